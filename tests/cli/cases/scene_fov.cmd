murk image fixtures/fov.json -o a.exr
