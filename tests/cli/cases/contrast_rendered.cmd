murk image fixtures/mark.json -q -o pic.exr
murk contrast pic.exr --target 12,12,16x16 --background 8,8,24x24 --json | /usr/bin/python3 -c '
import json, sys
for band in json.load(sys.stdin)["bands"]:
    print(band["band"], band["pixels_target"], band["pixels_background"], band["cl_target_g_m2"])
    print(band["contrast_inherent"] > band["contrast_apparent"] > 0)
    print("through the smoke: %.1f" % band["contrast_transmittance"])'
