for g in 0.5 0.6; do
    echo '{"medium": {"file": "fixtures/puff.vdb", "extinction": {"grid": "density", "scale": 2}, "asymmetry": '$g'}, "camera": {"size": [16, 12]}}' >$g.json
done
murk solve 0.5.json --threads 1 -q -o r.vdb && murk render 0.5.json --threads 1 --radiosity r.vdb -q -o a.exr && murk render 0.6.json --threads 1 --radiosity r.vdb -o b.exr
status=$?
rm 0.5.json 0.6.json
exit $status
