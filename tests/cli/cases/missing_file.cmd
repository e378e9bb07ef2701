murk image fixtures/missing.vdb -o a.exr
