murk solve fixtures/puffs/puff.####.vdb -o -
