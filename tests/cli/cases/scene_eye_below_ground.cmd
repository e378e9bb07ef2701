trap 'rm s.json' EXIT
echo '{"medium": {"file": "fixtures/puff.vdb", "extinction": 2}, "ground": {"height": 0}, "camera": {"eye": [3, 0, -1], "target": [0, 0, 1]}}' >s.json
murk image s.json --threads 1 -q -o a.exr
