murk info 'fixtures/puffs/puff.####.vdb' --json | python3 -c '
import json, sys
for line in sys.stdin:
    told = json.loads(line)
    print(told["frame"], told["status"], told["file"] if "file" in told else told["message"])'
