murk solve fixtures/puff.vdb --bands R,G,B,LWIR --threads 1 -q -o r.vdb && murk info r.vdb 2>/dev/null | cut -c1-25 &&
    murk render fixtures/puff.vdb --bands LWIR,G --radiosity r.vdb --size 16x12 --threads 1 -o a.exr &&
    murk render fixtures/puff.vdb --bands NIR --radiosity r.vdb --size 16x12 --threads 1 -o b.exr
