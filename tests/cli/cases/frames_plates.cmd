murk image fixtures/plates.json -q --threads 1 -o p.##.exr
oiiotool --stats p.01.exr p.02.exr | grep -o 'Max: [0-9.]*'
