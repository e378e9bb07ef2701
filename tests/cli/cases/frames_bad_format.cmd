murk image fixtures/puffs.json -q -o p.#.xyz --frames 1-100
