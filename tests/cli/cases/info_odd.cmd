murk info fixtures/odd.vdb --scale 1
