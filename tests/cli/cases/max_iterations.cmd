murk solve fixtures/no_ground.json --method pairwise --max-iterations 1 -q -o r.vdb
