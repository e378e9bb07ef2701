murk info fixtures/truncated.vdb
