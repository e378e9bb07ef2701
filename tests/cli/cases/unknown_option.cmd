murk image fixtures/puff.vdb -o a.exr --tolerence 1%
