murk solve - -q --tolerance 20% -o - <fixtures/puff.vdb | murk info - | tail -1
