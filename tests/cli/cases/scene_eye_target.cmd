murk image fixtures/eye_target.json -o a.exr
