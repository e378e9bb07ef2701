murk image fixtures/zero_size.json -o a.exr
