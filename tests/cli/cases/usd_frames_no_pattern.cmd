murk solve fixtures/puffs.json -o 'a.#.vdb' --usd a.usda
