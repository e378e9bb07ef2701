murk info fixtures/empty.vdb
