trap 'rm s.json' EXIT
echo '{"medium": {"file": "fixtures/puff.vdb", "extinction": 2}, "ground": {"reflectance": 0.5},
       "sun": {"direction": [0, 0, 1], "irradiance": 1}}' >s.json
murk image s.json --size 8x8 -o a.exr
