murk solve fixtures/puff.json -q -o r.vdb
murk render fixtures/puff.json --radiosity r.vdb --eye -3,-3,2 --size 16x12 -q -o a.exr && oiiotool --info a.exr
