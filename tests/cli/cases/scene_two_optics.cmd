trap 'rm s.json' EXIT
echo '{"medium": {"file": "fixtures/puff.vdb", "extinction": 1, "mass_extinction": 2}}' >s.json
murk image s.json -o a.exr
