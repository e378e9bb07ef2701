murk solve fixtures/puff.vdb -q -o r.vdb --emission-coefficient --extinction-grid --albedo-grid --half
murk info r.vdb | grep -vE "^murk"
