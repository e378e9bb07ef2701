murk solve fixtures/puffs/puff.0001.vdb --scale 5 --tolerance 20% -q -o radiosity.vdb
murk render fixtures/puffs/puff.0001.vdb --scale 5 --radiosity radiosity.vdb --size 4000x4000 --max-memory 256M -o out.exr
status=$?
rm radiosity.vdb
exit $status
