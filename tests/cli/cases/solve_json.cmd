murk solve fixtures/puff.json -q -o r.vdb --json | /usr/bin/python3 -c "
import json, sys
report = json.load(sys.stdin)
print(report[\"method\"], report[\"status\"], report[\"outputs\"][\"output\"])"
