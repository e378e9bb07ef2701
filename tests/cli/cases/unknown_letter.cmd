murk image fixtures/puff.vdb -o a.exr -x
