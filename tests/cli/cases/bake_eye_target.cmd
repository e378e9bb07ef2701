murk bake fixtures/puff.vdb --eye 1,1,5 --target 1,1,1 -o smoke.png
