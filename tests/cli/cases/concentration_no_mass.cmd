murk image volumes/plume64_f045.vdb --concentration 2 -o a.exr --threads 1
