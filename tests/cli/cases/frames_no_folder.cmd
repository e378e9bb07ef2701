murk solve fixtures/puffs.json -q -o nowhere/r.#.vdb --frames 1-100
