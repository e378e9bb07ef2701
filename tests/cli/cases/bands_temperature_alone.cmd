cat >s.json <<'E'
{"medium": {"file": "fixtures/puff.vdb", "temperature": 300}}
E
murk image s.json -o a.exr --threads 1
status=$?
rm -f s.json
exit $status
