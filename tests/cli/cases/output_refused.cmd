# A file system without room for names stands in for one that refuses, for root too.
murk image fixtures/puff.vdb -q --size 8x8 -o /proc/a.exr
