murk image fixtures/puffs.json -q -o p.##.exr --radiosity r.#.vdb --preview p.%02d.exr --frames 1-100
