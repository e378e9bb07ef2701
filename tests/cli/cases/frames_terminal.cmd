script -qec 'murk solve fixtures/puffs.json --threads 1 -o r.#.vdb --frames 1,4' /dev/null |
    tr '\r' '\n' | grep -o 'frame . ([^)]*) ' | uniq
