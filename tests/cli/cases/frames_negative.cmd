cp fixtures/puff.vdb n.-002.vdb
cp fixtures/puff.vdb n.0000.vdb
murk solve n.####.vdb -q --threads 1 --frames -2-0 -o r.####.vdb
murk solve n.####.vdb -q --threads 1 -o s.#.vdb
