murk image fixtures/puffs.json -o p.#.exr --deep deep.exr
