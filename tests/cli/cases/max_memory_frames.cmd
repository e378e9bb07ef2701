# Each worker has its share.
murk image 'fixtures/puffs/puff.####.vdb' --frames 1,2 --scale 5 --size 1000x1000 --jobs 4 --max-memory 64M -o 'out.####.exr'
