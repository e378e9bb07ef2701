murk image -o a.exr
