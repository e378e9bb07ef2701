murk solve fixtures/puffs.json -o r.#.vdb --ground-radiosity g.exr
