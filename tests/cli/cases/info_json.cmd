murk info fixtures/albedo.vdb --json | /usr/bin/python3 -c "
import json, sys
report = json.load(sys.stdin)
print(report[\"file\"], [grid[\"name\"] for grid in report[\"grids\"]])
print(sorted(report[\"grids\"][0]))
print(sorted(report[\"medium\"]), report[\"medium\"][\"zones\"])"
