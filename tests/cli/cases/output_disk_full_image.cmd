(ulimit -S -f 4; trap "" XFSZ; exec murk image fixtures/puff.json -q --size 256x256 -o a.png) 2>&1 | cat >&2; exit "${PIPESTATUS[0]}"
