murk image fixtures/text.vdb -o a.exr
