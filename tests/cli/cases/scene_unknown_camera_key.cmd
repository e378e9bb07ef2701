murk image fixtures/unknown_camera.json -o a.exr
