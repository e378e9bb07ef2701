murk solve --help
