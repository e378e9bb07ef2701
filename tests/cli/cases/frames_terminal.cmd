script -qec 'murk solve fixtures/puffs.json --threads 1 -o r.#.vdb --frames 1,4' /dev/null |
    tr '\r' '\n' | grep -o '[0-9] of [0-9] frames' | uniq
