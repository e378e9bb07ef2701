murk image fixtures/puff.vdb -o missing/a.exr
