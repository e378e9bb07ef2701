murk solve fixtures/points.vdb --scale 2 --threads 1 -o a.vdb
