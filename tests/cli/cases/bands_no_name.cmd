cat >s.json <<'E'
{"medium": {"file": "fixtures/puff.vdb"}, "bands": [{"wavelength": [8e-6, 12e-6]}]}
E
murk image s.json -o a.exr --threads 1
status=$?
rm -f s.json
exit $status
