murk image fixtures/empty.vdb --size 32x32 -q -o a.exr
