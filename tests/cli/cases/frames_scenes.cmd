murk image fixtures/cut_##.json --threads 1 -o p.##.exr
