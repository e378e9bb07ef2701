murk solve fixtures/no_ground.json -q -o r.vdb
murk render fixtures/no_ground.json --radiosity r.vdb -v --threads 1 --size 8x8 -o a.exr
