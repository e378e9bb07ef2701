murk contrast fixtures/pics/pic.0001.exr --target 2,1,3x2 --background 0,0,8x5 --json -o table.csv | grep -c contrast_apparent
wc -l <table.csv
