murk image fixtures/puff.vdb --albedo glow -o a.exr
