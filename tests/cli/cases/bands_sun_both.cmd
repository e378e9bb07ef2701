cat >s.json <<'E'
{"medium": {"file": "fixtures/puff.vdb"}, "sun": {"irradiance": 1, "temperature": 5772}, "bands": [{"name": "R"}]}
E
murk image s.json -o a.exr --threads 1
status=$?
rm -f s.json
exit $status
