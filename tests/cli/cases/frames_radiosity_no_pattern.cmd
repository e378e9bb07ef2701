murk image fixtures/puffs.json -o p.#.exr --radiosity r.vdb --frames 1
