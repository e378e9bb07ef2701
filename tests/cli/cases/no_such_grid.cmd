murk image fixtures/puff.vdb --grid smoke -o a.exr
