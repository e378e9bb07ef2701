# Flattened it is the flat picture, with ground and sky and without.
murk image fixtures/puff.json -q --size 48x40 -o flat.exr --deep deep.exr --radiosity r.vdb
oiiotool deep.exr --flatten -o flattened.exr
oiiotool flat.exr --ch R,G,B,A flattened.exr --ch R,G,B,A --fail 2e-6 --hardfail 2e-6 --diff | tail -1
oiiotool --info -v deep.exr | grep -E 'deep|channel list|compression|Software|units|command'
murk render fixtures/puff.json --radiosity r.vdb -q --no-background --size 48x40 -o smoke.exr --deep smoke_deep.exr
oiiotool smoke_deep.exr --flatten -o flattened.exr
oiiotool smoke.exr --ch R,G,B,A flattened.exr --ch R,G,B,A --fail 2e-6 --hardfail 2e-6 --diff | tail -1
oiiotool --info --stats smoke_deep.exr | grep -c 'Min deep samples in any pixel : 0'
