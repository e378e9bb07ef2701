murk image fixtures/albedo.vdb --voxel-size 0.2 --voxels corner --up y --fov 30 --samples 1 --size 16x12 \
    --kernel portable -q -o a.exr --radiosity r.vdb --json | /usr/bin/python3 -c '
import json, sys
report = json.load(sys.stdin)
print(report["kernel"], report["zones"], report["inputs"]["extinction_scale"])'
murk info r.vdb --json | /usr/bin/python3 -c '
import json, sys
print(json.load(sys.stdin)["grids"][0]["voxel_size"])'
