murk bake fixtures/puff.vdb -o smoke.png --radiosity lit.png
