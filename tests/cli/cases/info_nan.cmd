murk info fixtures/nan.vdb
