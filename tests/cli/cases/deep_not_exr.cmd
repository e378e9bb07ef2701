murk image fixtures/puff.json -o a.exr --deep deep.png
