murk image fixtures/no_ground.json --directions 100 --rays 2 --size 8x8 -q -o a.exr --json | /usr/bin/python3 -c '
import json, sys
report = json.load(sys.stdin)
print(report["directions"], report["subdivision"])'
