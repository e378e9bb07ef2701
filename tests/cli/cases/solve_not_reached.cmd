murk solve fixtures/puff.vdb -q -o r.vdb --tolerance 0.0001% --max-iterations 1
