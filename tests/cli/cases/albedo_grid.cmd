murk image fixtures/albedo.vdb --albedo bad -o a.exr
