murk render fixtures/puffs.json --radiosity - -o p.#.exr
