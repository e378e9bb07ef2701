murk bake 'fixtures/puffs/puff.####.vdb' --frames 1,2,4 --scale 5 --flipbook 2x2 --size 16x12 -q --threads 1 -o smoke.exr &&
    oiiotool --info smoke_positive.exr smoke_negative.exr &&
    oiiotool smoke_positive.exr --cut 16x12+16+12 --printstats | grep Max # the fourth cell is empty
