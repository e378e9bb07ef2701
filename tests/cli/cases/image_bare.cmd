murk image fixtures/puff.vdb --size 8x8 -o a.exr
