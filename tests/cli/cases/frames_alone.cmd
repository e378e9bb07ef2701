murk image fixtures/puffs.json -q --threads 1 --tolerance 0.3% -o a.#.exr --frames 1,2,4
murk image fixtures/puffs.json -q --threads 1 --tolerance 0.3% -o b.#.exr --frames 4
oiiotool --diff --warn 0.0005 --fail 0.0005 a.4.exr b.4.exr | tail -1
oiiotool --diff --warn 0.0005 --fail 0.0005 a.1.exr a.4.exr | tail -1
