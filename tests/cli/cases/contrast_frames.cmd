murk contrast 'fixtures/pics/pic.####.exr' --target fixtures/pics/target.png --background fixtures/pics/background.png --bands LWIR --netd 0.1 --snr 50 -o table.csv --plot curves.png
cut -d, -f1-9,28,29 table.csv
