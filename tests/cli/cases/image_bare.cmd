murk image fixtures/puff.vdb --size 8x8 --tolerance 5% -o a.exr
