murk bench --help
