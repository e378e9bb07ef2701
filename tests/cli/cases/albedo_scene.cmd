murk image fixtures/albedo.json -o a.exr
