murk image fixtures/puffs.json -o p.####.exr --jobs 0
