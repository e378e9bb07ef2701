murk image fixtures/puff.vdb -o a.vdb
