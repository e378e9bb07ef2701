echo '{"wavelength": [0.4e-6, 0.8e-6], "mass_extinction": 8, "albedo": 0.2, "asymmetry": 0.3}' >o.json
murk image fixtures/puff.vdb --bands R,LWIR --obscurant o.json --concentration 2 -o a.exr --threads 1
status=$?
rm o.json
exit $status
