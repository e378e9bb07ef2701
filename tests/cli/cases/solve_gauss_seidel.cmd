murk solve fixtures/no_ground.json -o r.vdb --method pairwise --solver gauss-seidel
