for what in frame transmittance depth cl; do
    murk contrast 'fixtures/pics/pic.####.exr' --target 2,1,3x2 --background 0,0,8x5 --frames 1,2,4 -q -o table.csv --plot $what.png --against $what || exit
done
cmp -s cl.png frame.png || echo they differ
