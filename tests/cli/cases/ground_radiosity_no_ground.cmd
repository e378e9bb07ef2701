murk solve fixtures/no_ground.json -q -o r.vdb --ground-radiosity g.exr
