murk contrast fixtures/pics/pic.0001.exr
