murk solve fixtures/puff.vdb -o a.vdb --method line
