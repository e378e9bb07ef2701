murk solve fixtures/loose.json -q --threads 1 -o r.#.vdb
