echo '{"wavelength": 0.65e-6, "mass_extinction": 8, "albedo": 0.2, "asymmetry": 0.3}' >o.json
murk image fixtures/puff.vdb --bands R --obscurant o.json -o a.exr --threads 1
status=$?
rm o.json
exit $status
