murk render fixtures/puff.vdb --radiosity fixtures/albedo.vdb -o a.exr
