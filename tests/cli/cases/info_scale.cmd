murk info fixtures/puff.vdb --scale 3 | tail -1
