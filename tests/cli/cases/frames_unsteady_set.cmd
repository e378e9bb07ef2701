murk image fixtures/puffs.json --threads 1 --frames 1-2 -o p.####.exr --preview p.####.png --exposure 0
