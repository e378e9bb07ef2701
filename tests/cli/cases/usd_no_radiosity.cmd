murk image fixtures/puff.vdb -o a.exr --usd a.usda
