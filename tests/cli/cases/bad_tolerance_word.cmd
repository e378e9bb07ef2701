murk solve fixtures/puff.vdb -o a.vdb --tolerance=high
