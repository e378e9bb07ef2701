trap 'rm s.json' EXIT
echo '{"medium": {"file": "fixtures/puff.vdb", "extinction": 2}, "sun": {"direction": [0, 0, -1], "irradiance": 1e7}}' >s.json
murk solve s.json --threads 1 -q -o r.vdb --half
