murk contrast 'fixtures/pics/pic.####.exr' --target 2,1,3x2 --background 0,0,8x5 --plot curves.exr
