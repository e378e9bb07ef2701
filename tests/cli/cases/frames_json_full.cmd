murk solve fixtures/puffs.json -q --threads 1 -o r.#.vdb --frames 1-2 --json >/dev/full
