murk contrast 'fixtures/pics/pic.####.exr' --target 'fixtures/pics/target.$F.png' --background 0,0,8x5 --frames 1,2 --bands R -q | cut -d, -f1-4,28,29
