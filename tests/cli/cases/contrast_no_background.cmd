murk contrast fixtures/pics/pic.0001.exr --target 2,1,3x2
