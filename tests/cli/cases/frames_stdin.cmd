murk solve - -o r.#.vdb --frames 1-10
