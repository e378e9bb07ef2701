murk image fixtures/ground_size.json -o a.exr
