murk image fixtures/puff.vdb --scale 2 --threads 1 --size 24x16 -o a.exr --preview b.exr --show Z
