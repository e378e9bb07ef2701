murk solve fixtures/puff.vdb -o r.vdb --method pairwise --solver gauss-seidel
