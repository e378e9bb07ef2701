murk contrast 'fixtures/pics/no_cl.#.exr' --target 2,1,3x2 --background 0,0,8x5 -o table.csv --plot curves.png --against cl
