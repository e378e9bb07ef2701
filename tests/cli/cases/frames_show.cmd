murk image fixtures/puffs/puff.\$F4.vdb --scale 2 --threads 1 --size 16x12 --frames 1-2 -o p.####.png --show A
