murk solve fixtures/puff.json --frames 1-10 -o r.vdb
