murk solve fixtures/puff.vdb -o missing/a.vdb
