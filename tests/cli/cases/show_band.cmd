cat >s.json <<'F'
{"medium": {"file": "fixtures/puff.vdb", "extinction": {"grid": "density", "scale": 2}, "temperature": 290},
 "sky": {"temperature": 290}, "ground": {"temperature": 290, "reflectance": 0.1, "patches": [8, 8]},
 "camera": {"size": [32, 24]}, "bands": [{"name": "LWIR", "albedo": 0.3}]}
F
murk image s.json -q --threads 1 -o a.png --show LWIR.temperature --range 280:300 && murk image s.json -q --threads 1 -o b.png --show LWIR.temperatur
status=$?
rm -f s.json
exit $status
