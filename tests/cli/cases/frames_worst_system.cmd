mkdir out1 out3
murk solve fixtures/puffs.json -q --threads 1 -o out#/r.vdb --frames 1-3
