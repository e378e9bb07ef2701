# One frame that fails leaves a hole in the sheet, which is not written then.
mkdir r.0002.vdb
murk bake 'fixtures/puffs/puff.####.vdb' --frames 1,2 --scale 5 --flipbook 2x1 --size 8x8 --threads 1 --tolerance 5% -q \
    --radiosity 'r.####.vdb' -o smoke.png
status=$?
rm -r r.*
exit $status
