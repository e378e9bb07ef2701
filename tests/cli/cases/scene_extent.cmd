murk image fixtures/extent.json -o a.exr
