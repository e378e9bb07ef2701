murk bake fixtures/puff.vdb --scale 5 --size 16x16 -q --threads 1 -o smoke.tga --radiosity lit.vdb &&
    murk info lit.vdb 2>/dev/null | cut -c1-16
