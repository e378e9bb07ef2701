murk image fixtures/puff.json -q --size 8x8 -o a.exr
oiiotool --info -v a.exr | grep -E "channel list|Software|murk:"
