murk solve fixtures/points.vdb --grid points -o a.vdb
