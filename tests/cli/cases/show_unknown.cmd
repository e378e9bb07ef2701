murk image fixtures/puff.vdb --scale 2 --threads 1 --size 24x16 -v -o a.exr --preview a.png --radiosity r.vdb --show transmitance
