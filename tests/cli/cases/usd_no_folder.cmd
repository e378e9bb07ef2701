murk solve fixtures/puff.vdb -o a.vdb --usd nowhere/a.usda
