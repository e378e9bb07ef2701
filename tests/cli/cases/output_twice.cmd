murk image fixtures/puff.vdb -o a.exr --preview a.exr
