murk image fixtures/puff.vdb
