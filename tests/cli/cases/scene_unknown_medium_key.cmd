murk image fixtures/unknown_medium.json -o a.exr
