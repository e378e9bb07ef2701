murk image fixtures/puff.json -q -o a.exr --json | /usr/bin/python3 -c "
import json, sys
report = json.load(sys.stdin)
print(report[\"command\"], report[\"status\"])
print(sorted(report), sorted(report[\"energy\"]), sorted(report[\"seconds\"]), sep=\"\\n\")
print(report[\"zones\"], report[\"reached\"], report[\"estimate\"] <= report[\"tolerance\"])"
