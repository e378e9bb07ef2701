# What a fire radiates by itself is in the mask alone: the maps are those of the same smoke without.
printf '{"medium": {"file": "fixtures/puff.vdb", "extinction": {"grid": "density", "scale": 5}, "albedo": 0.5%s}}' \
    ', "emission": {"grid": "density", "scale": 100}' >fire.json
printf '{"medium": {"file": "fixtures/puff.vdb", "extinction": {"grid": "density", "scale": 5}, "albedo": 0.5}}' >smoke.json
for what in fire smoke; do murk bake $what.json --size 16x16 --threads 1 -q -o $what.exr; done
oiiotool fire_positive.exr smoke_positive.exr --fail 0 --warn 0 --diff | tail -1
oiiotool fire_negative.exr --ch R,G,B smoke_negative.exr --ch R,G,B --fail 0 --warn 0 --diff | tail -1
oiiotool fire_negative.exr --ch A --printstats | grep -E 'Min|Max'
oiiotool smoke_negative.exr --ch A --printstats | grep -E 'Min|Max'
