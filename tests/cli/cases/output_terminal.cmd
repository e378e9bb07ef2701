script -qec 'murk solve fixtures/puff.vdb -o -' /dev/null
