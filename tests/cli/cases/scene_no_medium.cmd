murk image fixtures/no_medium.json -o a.exr
