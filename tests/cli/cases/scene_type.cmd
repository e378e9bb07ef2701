murk image fixtures/type.json -o a.exr
