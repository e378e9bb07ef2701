murk image fixtures/puffs.json -o p.#.exr --preview p.png
