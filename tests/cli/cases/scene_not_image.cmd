trap 'rm s.json' EXIT
echo '{"medium": {"file": "fixtures/puff.vdb"}, "ground": {"reflectance": [0.5]}}' >s.json
murk image s.json -o a.exr
