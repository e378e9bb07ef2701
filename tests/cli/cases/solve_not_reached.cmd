murk solve fixtures/puff.json -q -o r.vdb --tolerance 0.0001% --max-iterations 1
