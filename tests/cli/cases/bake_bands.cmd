murk bake fixtures/puff.vdb --bands R,G -o smoke.png
