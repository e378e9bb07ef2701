murk bake fixtures/puff.vdb
