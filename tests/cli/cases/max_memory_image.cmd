murk image volumes/plume64_f045.vdb --size 4000x4000 --max-memory 256M -o out.exr
