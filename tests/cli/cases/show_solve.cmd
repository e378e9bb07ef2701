murk solve fixtures/puff.vdb -o a.vdb --show Z
