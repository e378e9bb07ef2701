trap 'rm s.json' EXIT
echo '{"medium": {"file": "fixtures/puff.vdb"}, "camera": {"eye": [1, 2]}}' >s.json
murk image s.json -o a.exr
