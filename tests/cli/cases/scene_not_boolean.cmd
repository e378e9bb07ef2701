trap 'rm s.json' EXIT
echo '{"medium": {"file": "fixtures/puff.vdb", "strict": 1}}' >s.json
murk image s.json -o a.exr
