murk image fixtures/ -o a.exr
