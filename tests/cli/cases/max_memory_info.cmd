murk info fixtures/tiles.vdb --max-memory 256M
