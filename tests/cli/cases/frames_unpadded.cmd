murk solve fixtures/puffs/loose.%d.vdb --threads 1 -o 'r.$F3.vdb'
