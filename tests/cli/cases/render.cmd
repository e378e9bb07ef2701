murk solve fixtures/puff.json -q -o r.vdb
murk image fixtures/puff.json -q -o direct.exr
murk render fixtures/puff.json --radiosity r.vdb -o again.exr
oiiotool --diff --warn 0.001 --fail 0.001 direct.exr again.exr | tail -1
