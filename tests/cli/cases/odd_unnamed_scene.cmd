echo '{"medium": {"file": "fixtures/odd.vdb", "extinction": {"grid": "density[1]", "scale": 2}, "albedo": {"grid": "[0]", "scale": 0.1}}}' >s.json
murk solve s.json --threads 1 -o a.vdb
status=$?
rm s.json
exit $status
