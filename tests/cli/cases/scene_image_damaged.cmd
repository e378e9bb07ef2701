trap 'rm s.json ground.exr' EXIT
echo 'no picture' >ground.exr
echo '{"medium": {"file": "fixtures/puff.vdb"}, "ground": {"reflectance": "ground.exr"}}' >s.json
murk image s.json -o a.exr
