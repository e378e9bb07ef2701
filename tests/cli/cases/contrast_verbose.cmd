murk contrast fixtures/pics/pic.0001.exr --target 2,1,3x2 --background 0,0,8x6 --threads 1 -v | cut -d, -f1-3
