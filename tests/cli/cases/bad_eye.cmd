murk image fixtures/puff.vdb -o a.exr --eye 1,2
