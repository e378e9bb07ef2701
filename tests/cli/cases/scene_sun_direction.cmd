murk image fixtures/sun_direction.json -o a.exr
