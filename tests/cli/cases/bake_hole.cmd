murk bake 'fixtures/puffs/puff.####.vdb' --frames 1,3 --scale 5 --flipbook 2x1 -o smoke.png -q
