murk image fixtures/unknown_top.json -o a.exr
