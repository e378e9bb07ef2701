murk solve fixtures/puffs/huff.####.vdb -o r.####.vdb --frames 3,5-7,9,8
