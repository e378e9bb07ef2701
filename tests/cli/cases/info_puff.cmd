murk info fixtures/puff.vdb
