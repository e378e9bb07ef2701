murk image fixtures/puff.vdb --bands R,LWIR --size 16x12 --threads 1 -q --json -o a.exr | python3 -c '
import json, sys
report = json.load(sys.stdin)
for band in report["bands"]:
    print(band["name"], band["wavelength"], band["mass_extinction"], band["reached"])
'
