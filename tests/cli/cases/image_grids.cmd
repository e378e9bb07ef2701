murk image fixtures/puff.json --size 8x8 -q -o a.exr --radiosity r.vdb --half --emission-coefficient --extinction-grid --albedo-grid
murk info r.vdb --json | /usr/bin/python3 -c '
import json, sys
for grid in json.load(sys.stdin)["grids"]:
    print(grid["name"], grid["type"], grid["active_voxels"])'
