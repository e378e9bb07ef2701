murk solve - -q -o - <fixtures/puff.vdb | murk info - | tail -1
