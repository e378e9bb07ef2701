murk image fixtures/puffs.json -o p.exr
