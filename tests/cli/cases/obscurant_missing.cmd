murk image volumes/plume64_f045.vdb --bands R --obscurant soot.json -o a.exr --threads 1
