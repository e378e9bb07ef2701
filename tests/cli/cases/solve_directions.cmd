murk solve fixtures/no_ground.json --directions 100 --rays 2 -q -o r.vdb --json | /usr/bin/python3 -c '
import json, sys
print(json.load(sys.stdin)["directions"])'
