cp fixtures/puff.vdb p.1.vdb
touch -d 2001-01-01 p.1.vdb
again() { murk solve p.#.vdb -q --frames 1 --threads 1 --resume --json "$@" | grep -o '"status": "[a-z]*"'; }
again -o r.#.vdb --scale 2
again -o r.#.vdb --scale 2
again -o r.#.vdb --scale 2 --half
rm p.1.vdb
