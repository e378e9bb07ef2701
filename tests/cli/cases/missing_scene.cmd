murk image fixtures/missing.json -o a.exr
