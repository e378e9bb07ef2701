medium="fixtures/albedo.vdb --grid density --scale 3 --albedo good --voxel-size 0.2 --voxels corner --up y --strict"
murk solve $medium -q -o r.vdb
murk render fixtures/albedo.vdb --grid density --scale 3 --albedo good --voxel-size 0.2 --voxels corner --up y --strict \
    --radiosity r.vdb --size 8x8 --kernel portable -q -o a.exr --json | /usr/bin/python3 -c '
import json, sys
report = json.load(sys.stdin)
print(report["status"], report["zones"], report["inputs"]["extinction_scale"], report["inputs"]["radiosity"])'
