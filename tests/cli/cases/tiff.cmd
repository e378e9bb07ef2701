# The same floats as in the EXR.
murk solve fixtures/puff.json -q -o r.vdb
murk render fixtures/puff.json -q --radiosity r.vdb --size 48x40 -o a.exr
murk render fixtures/puff.json -q --radiosity r.vdb --size 48x40 -o a.tif
oiiotool a.exr --ch R,G,B,A a.tif --fail 0 --hardfail 0 --diff | tail -1
oiiotool --info -v a.tif | grep -E 'channel list|float|ImageDescription|Software|Unassociated'
