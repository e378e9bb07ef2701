ulimit -f 0; trap "" XFSZ
murk image fixtures/puff.vdb -q --size 64x64 -o a.exr
