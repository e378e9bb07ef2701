murk image fixtures/puff.vdb -o -
