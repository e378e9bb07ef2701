trap 'rm s.json' EXIT
echo '{"medium": {"file": "fixtures/puff.vdb", "extinction": 2}, "ground": {"reflectance": "."}}' >s.json
murk image s.json --threads 1 -q -o a.exr
