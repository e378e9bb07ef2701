murk image fixtures/puff.vdb -o a.exr --size 0x480
