murk image fixtures/puff.vdb --albedo 1.5 -o a.exr
