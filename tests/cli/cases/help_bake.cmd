murk bake --help
