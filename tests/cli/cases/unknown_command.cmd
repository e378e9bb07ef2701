murk imgae fixtures/puff.vdb -o a.exr
