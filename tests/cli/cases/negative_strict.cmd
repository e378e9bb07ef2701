murk solve fixtures/negative.vdb --strict -o a.vdb
