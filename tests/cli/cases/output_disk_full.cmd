(ulimit -S -f 4; trap "" XFSZ; exec murk solve fixtures/puff.json -q -o a.vdb) 2>&1 | cat >&2; exit "${PIPESTATUS[0]}"
