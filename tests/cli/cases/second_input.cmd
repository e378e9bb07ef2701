murk image fixtures/puff.vdb fixtures/nan.vdb -o a.exr
