murk solve fixtures/odd.vdb --grid '[1]' --scale 1 --threads 1 -q -o a.vdb && murk info a.vdb --scale 1
