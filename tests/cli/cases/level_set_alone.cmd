murk image fixtures/surface.vdb -o a.exr
