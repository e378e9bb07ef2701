cat >s.json <<'E'
{"medium": {"file": "fixtures/puff.vdb", "extinction": {"grid": "density", "scale": 2}, "concentration": {"grid": "density", "scale": 1.5}, "temperature": 290},
 "sky": {"temperature": 290}, "ground": {"temperature": 290, "reflectance": 0.1, "patches": [8, 8]},
 "camera": {"size": [32, 24]},
 "bands": [{"name": "LWIR", "mass_extinction": 0.4, "albedo": 0.3}, {"name": "R", "sun": {"temperature": 5772}}]}
E
murk image s.json -o a.exr --threads 1 --ground-radiosity g.exr && oiiotool --info -v a.exr | grep -E 'channel list|murk:bands' && oiiotool a.exr --ch LWIR.temperature -o t.exr && oiiotool --stats t.exr | grep -E 'Min|Max' && rm t.exr && oiiotool --info -v g.exr | grep 'channel list'
status=$?
rm -f s.json
exit $status
