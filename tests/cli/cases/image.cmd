murk image fixtures/puff.json -o a.exr --preview a.png --radiosity r.vdb --ground-radiosity g.exr
