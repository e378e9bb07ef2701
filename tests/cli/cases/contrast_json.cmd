murk contrast 'fixtures/pics/pic.####.exr' --target 2,1,3x2 --background 0,0,8x5 --frames 1,3 --snr 50 --json | /usr/bin/python3 -c '
import json, sys
for line in sys.stdin:
    report = json.loads(line)
    print(report["frame"], report["status"], report.get("input"), report.get("target"))
    print(report.get("message"))
    for band in report.get("bands", []):
        print(band["band"], band["wavelength_m"], band["cnr_thermal"], band["pixels_target"],
              *(round(band[key], 4) for key in ("contrast_apparent", "dt_apparent_K", "cnr_radiance")))'
