mkdir a.exr && murk image fixtures/puff.vdb -o a.exr; status=$?; rmdir a.exr; exit $status
