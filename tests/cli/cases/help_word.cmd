murk help solve | head -1
