murk solve fixtures/puffs/huff.####.vdb -o r.####.vdb
