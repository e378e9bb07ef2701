cp fixtures/puff.vdb p.1.vdb
touch -d 2001-01-01 p.1.vdb
murk solve p.#.vdb -q --threads 1 -o r.#.vdb
murk solve p.#.vdb -q --threads 1 -o r.#.vdb --resume --json
