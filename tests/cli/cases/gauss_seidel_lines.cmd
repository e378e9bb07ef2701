murk solve fixtures/puff.vdb -o r.vdb --solver gauss-seidel
