murk solve volumes/plume64_f045.vdb --max-memory 2X -o out.vdb
