ulimit -f 0; trap "" XFSZ
murk solve fixtures/puff.vdb -q -o a.vdb
