murk image fixtures/no_image.json -o a.exr
