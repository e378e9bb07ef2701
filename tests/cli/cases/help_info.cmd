murk info --help
