murk image fixtures/truncated.vdb -o a.exr
