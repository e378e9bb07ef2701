# Whatever else bake takes of the options of a solve and of a picture.
echo '{"wavelength": [4e-7, 7e-7], "mass_extinction": [10, 8], "albedo": 0.25, "asymmetry": 0.5}' >soot.json
murk bake fixtures/puff.vdb --size 16x16 --threads 1 -o a.png --grid density --voxel-size 0.05 --voxels center --up z --strict \
    --samples 1 --exposure -1 --kernel portable --directions 48 --rays 1 --max-iterations 100 --max-memory 1G --straight \
    --json -v 2>/dev/null |
    /usr/bin/python3 -c 'import json, sys; print([light["name"] for light in json.load(sys.stdin)["lights"]])'
murk bake fixtures/puff.vdb --size 16x16 --threads 1 -q -o b.exr --method pairwise --solver gauss-seidel --epsilon 1e-6 --window 4x4x4
murk bake fixtures/puff.vdb --size 16x16 --threads 1 -q -o c.exr --obscurant soot.json --bands G --concentration 1 --tolerance 5% \
    --radiosity r.vdb --half --emission-coefficient --extinction-grid --albedo-grid
/usr/bin/python3 -c 'import pyopenvdb; print(len(pyopenvdb.readAllGridMetadata("r.vdb")))'
rm soot.json
