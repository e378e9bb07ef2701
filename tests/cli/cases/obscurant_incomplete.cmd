trap 'rm o.json' EXIT
echo '{"wavelength": 5e-7, "mass_extinction": 1, "albedo": 0}' >o.json
murk image fixtures/puff.vdb --bands R --obscurant o.json --concentration 1 -o a.exr
