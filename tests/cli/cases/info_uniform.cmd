murk info fixtures/uniform.json | tail -1
