murk solve fixtures/puffs.json -q --threads 1 -o r.####.vdb --frames 1,2
murk image fixtures/puffs.json -q --threads 1 -o direct.####.exr --frames 1,2
murk render fixtures/puffs.json --threads 1 --radiosity 'r.$F4.vdb' -o again.####.exr --frames 2,1
for frame in 0001 0002; do
    oiiotool --diff --warn 0.001 --fail 0.001 direct.$frame.exr again.$frame.exr | tail -1
done
