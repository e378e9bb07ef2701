murk info fixtures/puff.vdb --frames 1-3
