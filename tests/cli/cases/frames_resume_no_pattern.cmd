murk image fixtures/puff.vdb --resume -o p.exr
