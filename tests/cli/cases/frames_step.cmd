murk solve fixtures/puffs/puff.####.vdb -q --threads 1 -o r.#.vdb --frames 1-9x3
