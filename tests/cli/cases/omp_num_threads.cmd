OMP_NUM_THREADS=3 murk solve fixtures/puff.json -q -o r.vdb --json | grep -o '"threads": [0-9]*'
OMP_NUM_THREADS=3 murk solve fixtures/puff.json -q --threads 2 -o r.vdb --json | grep -o '"threads": [0-9]*'
