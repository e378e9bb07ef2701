trap 'rm o.json' EXIT
echo '{"wavelength": [], "mass_extinction": 1, "albedo": 0, "asymmetry": 0}' >o.json
murk image fixtures/puff.vdb --bands R --obscurant o.json --concentration 1 -o a.exr
