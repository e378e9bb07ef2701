murk image fixtures/syntax.json -o a.exr
