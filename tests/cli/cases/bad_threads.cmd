murk solve fixtures/puff.vdb -o a.vdb --threads 0
