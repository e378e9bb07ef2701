murk solve fixtures/flames.vdb --scale 2 --threads 1 -o a.vdb
