murk contrast fixtures/pics/pic.0002.exr --target 2,1,3x2 --background 0,0,8x5 >rectangles
murk contrast fixtures/pics/pic.0002.exr --target fixtures/pics/target.png --background fixtures/pics/background.png >masks
cmp rectangles masks && rm rectangles masks
