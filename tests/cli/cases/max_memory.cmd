murk solve volumes/plume64_f045.vdb --threads 2 --max-memory 2M -o out.vdb
