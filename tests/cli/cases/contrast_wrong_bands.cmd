murk contrast fixtures/pics/wrong.exr --target 2,1,3x2 --background 0,0,8x5
