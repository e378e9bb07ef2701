murk --version
