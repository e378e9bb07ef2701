murk contrast fixtures/pics/pic.0001.exr --target 2,1,3x2 --background 0,0,8x5 --bands MWIR
