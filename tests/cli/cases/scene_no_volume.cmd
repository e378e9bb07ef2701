murk image fixtures/no_volume.json -o a.exr
