murk image fixtures/puff.vdb -o a.exr --tolerance 0
