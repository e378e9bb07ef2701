murk solve fixtures/albedo.vdb --grid density --scale 3 --albedo good --voxel-size 0.2 --voxels corner --up y \
    --kernel portable -q -o r.vdb --extinction-grid --albedo-grid --json | /usr/bin/python3 -c '
import json, sys
report = json.load(sys.stdin)
print(report["kernel"], report["zones"], report["inputs"]["extinction_scale"])'
murk info r.vdb --json | /usr/bin/python3 -c '
import json, sys
for grid in json.load(sys.stdin)["grids"]:
    print(grid["name"], grid["voxel_size"][0], "%.4g" % grid["value_max"])'
