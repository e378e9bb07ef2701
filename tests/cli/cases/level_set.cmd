murk image fixtures/odd.vdb --grid surface --scale 2 --threads 1 --size 16x12 -o a.exr
