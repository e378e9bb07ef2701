murk bake volumes/plume64_f045.vdb --size 2048x2048 --max-memory 256M -o out.png
