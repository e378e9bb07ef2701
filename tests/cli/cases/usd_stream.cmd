murk solve fixtures/puff.vdb -o - --usd a.usda | cat; exit ${PIPESTATUS[0]}
