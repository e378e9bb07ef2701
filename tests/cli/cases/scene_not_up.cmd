trap 'rm s.json' EXIT
echo '{"medium": {"file": "fixtures/puff.vdb"}, "up": "x"}' >s.json
murk image s.json -o a.exr
