murk image fixtures/nan.vdb --strict -o a.exr
