murk solve fixtures/puff.vdb -o a.vdb --usd a.usd
