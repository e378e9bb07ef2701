murk image volumes/plume64_f045.vdb --size 640x480 --max-memory 64M -o out.exr --deep deep.exr
