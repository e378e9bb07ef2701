murk image fixtures/puff.vdb --size 32x32 -q -o a.exr
