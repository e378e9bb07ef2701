# A file system that is full, as far as one process can have it: no file may grow beyond 4 KiB.
for name in out.exr out.png; do
    (ulimit -S -f 4; murk image volumes/box.vdb --tolerance 5% --size 256x256 -q -o $name 2>&1) | cat
done
(ulimit -S -f 4; murk solve volumes/box.vdb --tolerance 5% -q -o out.vdb 2>&1) | cat
