cp fixtures/puff.vdb p.1.vdb
cp fixtures/puff.vdb p.2.vdb
murk solve p.#.vdb -q --threads 1 -o r.#.vdb
rm p.1.vdb p.2.vdb
murk render fixtures/puff.vdb --threads 1 --size 16x12 --radiosity r.#.vdb -o p.#.exr
