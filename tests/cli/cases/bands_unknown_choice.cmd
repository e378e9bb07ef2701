cat >s.json <<'E'
{"medium": {"file": "fixtures/puff.vdb"}, "bands": [{"name": "LWIR"}]}
E
murk image s.json -o a.exr --threads 1 --bands LWR
status=$?
rm -f s.json
exit $status
