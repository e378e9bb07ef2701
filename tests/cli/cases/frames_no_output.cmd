murk image fixtures/puffs.json --frames 1
