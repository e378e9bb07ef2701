trap 'rm s.json' EXIT
echo '{"medium": {"file": "fixtures/puff.vdb", "extinction": 2}, "camera": {"eye": [0, 0, 5], "target": [0, 0, 1], "up": [0, 0, 1]}}' >s.json
murk image s.json --threads 1 -q -o a.exr
