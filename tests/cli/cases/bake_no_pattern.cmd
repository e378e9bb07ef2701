murk bake 'fixtures/puffs/puff.####.vdb' --frames 1,2 -o smoke.png
