murk solve fixtures/puffs.json --threads 1 -o 'r.####.vdb'
