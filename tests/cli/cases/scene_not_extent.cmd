trap 'rm s.json' EXIT
echo '{"medium": {"file": "fixtures/puff.vdb"}, "ground": {"extent": [0, 0, 1, 1]}}' >s.json
murk image s.json -o a.exr
