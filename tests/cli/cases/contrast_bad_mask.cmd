murk contrast fixtures/pics/pic.0001.exr --target fixtures/text.vdb --background 0,0,8x5
