murk contrast fixtures/pics/pic.0001.exr --target fixtures/pics/small.png --background 0,0,8x5
