murk --help
