murk image fixtures/puff.vdb --bands , -o a.exr
