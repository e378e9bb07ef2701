# The first frame waits in a pipe until the second one is there.
mkfifo p.1.vdb
cp fixtures/puff.vdb p.2.vdb
murk solve p.#.vdb -q --scale 2 --threads 2 --jobs 2 --frames 1-2 --json -o r.#.vdb >lines &
timeout 60 bash -c "until [ -e r.2.vdb ]; do sleep 0.05; done"
wc -c <lines
cat fixtures/puff.vdb >p.1.vdb
wait
grep -o '"frame": [0-9], "status": "[a-z]*"' lines
rm p.* r.* lines
