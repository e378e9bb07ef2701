murk bake fixtures/puff.vdb --flipbook 0x4 -o smoke.png
