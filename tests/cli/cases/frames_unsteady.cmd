murk image fixtures/puffs/puff.\$F4.vdb --threads 1 --size 16x12 --frames 1-2 -o p.####.exr --preview p.####.png
