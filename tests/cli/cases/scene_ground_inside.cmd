murk image fixtures/ground_inside.json -o a.exr
