# The second frame waits in a pipe, where its process is killed.
for frame in 1 3; do cp fixtures/puff.vdb p.$frame.vdb; done
mkfifo p.2.vdb
murk solve p.#.vdb -q --scale 2 --threads 1 --frames 1-3 --json -o r.#.vdb >lines &
exec 3>p.2.vdb
kill -KILL $(cat /proc/$!/task/$!/children)
wait $!
status=$?
grep -o '"frame": [0-9], "status": "[a-z]*"' lines
grep -o '"message".*' lines
rm p.* lines
exit $status
