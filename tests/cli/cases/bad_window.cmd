murk solve fixtures/puff.vdb -o a.vdb --method pairwise --window 3x3
