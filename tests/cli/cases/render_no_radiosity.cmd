murk render fixtures/puff.vdb -o a.exr
