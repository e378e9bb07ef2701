murk bench --parts growth --cases box --sizes 200 --runs 1 --kernel portable -v --json | /usr/bin/python3 -c '
import json, sys
print([run["kernel"] for run in json.load(sys.stdin)["growth"]])'
