cat >s.json <<'E'
{"medium": {"file": "fixtures/odd.vdb", "extinction": {"grid": "density", "scale": 1}, "albedo": 0.2,
            "temperature": {"grid": "coarse", "scale": 600}},
 "camera": {"size": [16, 12]}, "bands": [{"name": "LWIR"}]}
E
murk image s.json --threads 1 -o a.exr
status=$?
rm s.json
exit $status
