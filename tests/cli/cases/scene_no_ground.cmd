murk solve fixtures/no_ground.json -o a.vdb --ground-radiosity g.exr
