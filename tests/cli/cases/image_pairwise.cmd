murk image fixtures/no_ground.json --method pairwise --solver gauss-seidel --epsilon 1e-3 --max-iterations 50 \
    --window 3x3x3 --size 8x8 -q -o a.exr --json | /usr/bin/python3 -c '
import json, sys
report = json.load(sys.stdin)
print(report["method"], report["solver"], report["multiplications_window"])'
