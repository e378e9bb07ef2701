(ulimit -S -f 1; trap "" XFSZ; exec murk image fixtures/puff.json -q --size 64x64 -o a.png) 2>&1 | cat >&2; exit "${PIPESTATUS[0]}"
