murk solve fixtures/odd.vdb --albedo coarse --scale 1 --threads 1 -v -o a.vdb
