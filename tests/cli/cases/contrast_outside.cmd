murk contrast fixtures/pics/pic.0001.exr --target 6,1,3x2 --background 0,0,8x5
