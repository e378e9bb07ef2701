murk solve fixtures/puffs.json -q --threads 1 -o r.#.vdb --frames 1-3 --tolerance 0.0001% --max-iterations 1
