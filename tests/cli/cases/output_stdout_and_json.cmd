murk solve fixtures/puff.vdb -o - --json
