murk image fixtures/frustum.vdb -o a.exr
