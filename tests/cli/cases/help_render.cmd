murk render --help
