murk info fixtures/nan.vdb --strict -v
