murk image fixtures/ground_range.json -o a.exr
