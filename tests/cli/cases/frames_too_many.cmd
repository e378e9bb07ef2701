murk solve fixtures/puffs.json -o r.#.vdb --frames 1-1000001
