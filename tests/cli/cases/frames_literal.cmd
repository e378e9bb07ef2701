cp fixtures/puff.vdb 'puff#.vdb'
murk solve 'puff#.vdb' -q --threads 1 -o r.vdb
murk solve 'puff#.vdb' -q --frames 1-2 -o s.#.vdb
