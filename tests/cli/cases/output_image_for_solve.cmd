murk solve fixtures/puff.vdb -o a.exr
