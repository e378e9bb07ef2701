murk contrast fixtures/pics/unknown.exr --target 2,1,3x2 --background 0,0,8x5 | cut -d, -f1-9,24-
