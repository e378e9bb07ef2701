murk solve - -o a.vdb <fixtures/text.vdb
