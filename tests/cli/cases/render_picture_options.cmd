murk solve fixtures/puff.json -q -o r.vdb
murk render fixtures/puff.json --radiosity r.vdb --eye 3,-3,1 --target 0.3,0.3,0.3 --fov 20 --samples 1 \
    --no-background --size 16x12 -q -o a.exr --preview a.png --exposure 1
murk render fixtures/puff.json --radiosity r.vdb --size 160x120 -q -o b.exr --preview b.png --show Z --range 3:5
# Without a background the ground is not in the picture.
for picture in a b; do
    oiiotool $picture.exr --ch R --crop 1x1+0+0 --printstats | grep -o 'Stats Max: *0\.0*[1-9]' >/dev/null && echo "$picture has a ground"
done
exit 0
