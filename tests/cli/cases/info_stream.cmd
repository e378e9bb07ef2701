murk info - <fixtures/puff.vdb | tail -1
