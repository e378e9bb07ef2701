for epsilon in 1e-1 1e-8; do
    murk solve fixtures/no_ground.json --method pairwise --solver gauss-seidel --epsilon $epsilon -q -o r.vdb --json
done | /usr/bin/python3 -c '
import json, sys
few, many = (json.loads(line)["iterations"] for line in sys.stdin)
print("fewer iterations" if few < many else (few, many))'
