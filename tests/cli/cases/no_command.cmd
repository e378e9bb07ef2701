murk
