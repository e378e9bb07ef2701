murk image fixtures/puffs.json --threads 1 -o p.####.exr --frames 1-3 --json | /usr/bin/python3 -c '
import json, sys
for line in sys.stdin:
    report = json.loads(line)
    print(report["frame"], report["status"], report.get("zones"), report.get("outputs", {}).get("output"))
    print(report.get("message"), report.get("command"), report.get("inputs"))'
