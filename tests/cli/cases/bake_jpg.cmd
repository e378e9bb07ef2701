murk bake fixtures/puff.vdb -o smoke.jpg
