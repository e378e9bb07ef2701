# Names are told in one line and without commands to the terminal.
murk info $'no\nsuch\e[2J.vdb'
