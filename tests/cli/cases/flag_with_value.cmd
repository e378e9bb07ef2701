murk image fixtures/puff.vdb -o a.exr --json=yes
