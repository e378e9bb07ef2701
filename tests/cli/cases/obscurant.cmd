echo '{"wavelength": [0.4e-6, 0.8e-6], "mass_extinction": [8, 4], "albedo": 0.2, "asymmetry": 0.3}' >o.json
cat >s.json <<'E'
{"medium": {"file": "fixtures/puff.vdb", "obscurant": "o.json", "concentration": 0.5},
 "bands": [{"name": "R"}, {"name": "LWIR", "extinction": 0.1}]}
E
murk image s.json --size 16x12 -o a.exr --threads 1 -q --json | python3 -c '
import json, sys
for band in json.load(sys.stdin)["bands"]:
    print(band["name"], band["mass_extinction"])'
status=$?
rm o.json s.json
exit $status
