trap 'rm s.json' EXIT
echo '{"medium": {"file": "fixtures/puff.vdb", "voxels": "middle"}}' >s.json
murk image s.json -o a.exr
