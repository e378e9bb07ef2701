murk solve fixtures/odd.vdb --grid densty -o a.vdb
