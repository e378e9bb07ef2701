murk solve fixtures/odd.vdb --grid mask --scale 2 --threads 1 -o a.vdb
