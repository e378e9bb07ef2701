cp -r fixtures/puffs fixtures/puffs.json .
touch -d 2001-01-01 puffs/* puffs.json
work() { murk image puffs.json --threads 1 -o p.####.exr --radiosity r.####.vdb --frames 1-4 --resume; }
work
echo again
work 2>&1
echo an output is missing, an input is newer
rm r.0001.vdb
touch -d 2100-01-01 puffs/puff.0002.vdb
work 2>&1
echo the scene is newer
touch -d 2100-01-01 puffs.json
work 2>&1
rm -r puffs puffs.json
