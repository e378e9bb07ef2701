murk info 'fixtures/puffs/puff.####.vdb' --frames 1,2,5
