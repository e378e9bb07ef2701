murk solve fixtures/puffs.json --frames 1-2 --threads 1 -q -o r.####.vdb
murk render --jobs 1 fixtures/puffs.json --frames 1-2 --threads 1 --radiosity r.####.vdb -q -o a.####.exr
murk render fixtures/puffs.json --frames 1-2 --threads 1 --radiosity r.####.vdb -q -o a.####.exr --resume --json
