mkdir 'shot#1' take_1 take_2
for frame in 1 2; do
    cp fixtures/puff.vdb "shot#1/p.$frame.vdb"
    cp fixtures/puff.vdb take_$frame/p.vdb
done
murk solve 'shot#1/p.#.vdb' -q --threads 1 -o 'shot#1/r.##.vdb'
murk solve 'take_#/p.vdb' -q --threads 1 -o 'take_#/r.vdb'
rm shot#1/p.* take_?/p.vdb
