murk contrast --help
