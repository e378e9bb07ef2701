echo '{"wavelength": [0.4e-6, 0.8e-6], "mass_extinction": [8, 4], "albedo": 0.2, "asymmetry": 0.3}' >o.json
murk solve fixtures/puff.vdb --bands R --obscurant o.json --concentration 0.5 --threads 1 -q -o r.vdb --json |
    /usr/bin/python3 -c '
import json, sys
report = json.load(sys.stdin)
print(report["bands"][0]["mass_extinction"], report["inputs"]["extinction_scale"])'
murk render fixtures/puff.vdb --bands R --obscurant o.json --concentration 0.5 --threads 1 --radiosity r.vdb \
    --size 8x8 -q -o a.exr && oiiotool --info -v a.exr | grep 'murk:bands'
status=$?
rm o.json
exit $status
