cp fixtures/points.vdb p.1.vdb && cp p.1.vdb p.2.vdb && murk info 'p.#.vdb' --frames 1-2 >told
status=$?
rm -f p.1.vdb p.2.vdb told
exit $status
