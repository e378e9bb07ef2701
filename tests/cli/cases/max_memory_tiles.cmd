murk solve fixtures/tiles.vdb --max-memory 256M -o out.vdb
