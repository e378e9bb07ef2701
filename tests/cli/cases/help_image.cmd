murk image --help
