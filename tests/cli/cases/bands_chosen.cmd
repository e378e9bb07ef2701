cat >s.json <<'E'
{"medium": {"file": "fixtures/puff.vdb"}, "bands": [{"name": "R"}, {"name": "LWIR"}, {"name": "X", "wavelength": 4e-6}]}
E
murk image s.json -o a.exr --threads 1 --bands X,R --size 16x12 && oiiotool --info -v a.exr | grep -E 'murk:bands'
status=$?
rm -f s.json
exit $status
