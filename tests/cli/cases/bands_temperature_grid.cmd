cat >s.json <<'E'
{"medium": {"file": "fixtures/puff.vdb", "temperature": {"scale": 300}}, "bands": [{"name": "LWIR"}]}
E
murk image s.json -o a.exr --threads 1
status=$?
rm -f s.json
exit $status
