murk image fixtures/unknown_top.json -o p.#.exr --frames 1-100
