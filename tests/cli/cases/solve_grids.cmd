murk solve fixtures/puff.json -q -o r.vdb --emission-coefficient --extinction-grid --albedo-grid --half
murk info r.vdb --json | /usr/bin/python3 -c "
import json, sys
for grid in json.load(sys.stdin)[\"grids\"]:
    print(grid[\"name\"], grid[\"type\"], grid[\"class\"], grid[\"active_voxels\"], grid[\"box_min\"])"
