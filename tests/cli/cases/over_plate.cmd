# Smoke without a background, over a plate, is the picture that murk makes before this plate.
oiiotool --pattern fill:topleft=0.1,0.2,0.4:bottomright=0.9,0.7,0.2:topright=0.3,0.5,0.1:bottomleft=0.6,0.1,0.3 64x48 3 -d float -o plate.exr
cat >s.json <<'E'
{"medium": {"file": "fixtures/puff.vdb", "extinction": {"grid": "density", "scale": 2}}, "sky": {"radiance": 0.2}, "sun": {"irradiance": 2},
 "camera": {"size": [64, 48]}, "background": "plate.exr"}
E
murk image s.json -o before.exr --threads 1 -q && murk image s.json --no-background -o smoke.exr --threads 1 -q &&
    oiiotool smoke.exr --ch R,G,B,A plate.exr --ch R,G,B,A=1 --over --ch R,G,B -o over.exr &&
    oiiotool before.exr --ch R,G,B -o rgb.exr && idiff -fail 0.003 over.exr rgb.exr >/dev/null
status=$?
rm -f s.json plate.exr before.exr smoke.exr over.exr rgb.exr
exit $status
