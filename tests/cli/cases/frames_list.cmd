murk solve fixtures/puffs.json --threads 1 -o r.%02d.vdb --frames 4-1,2
