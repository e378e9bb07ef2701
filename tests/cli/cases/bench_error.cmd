printf 'pictures,a path tracer,0.5,8.25,4 spp\npictures,a path tracer,2,4.1,16 spp\n' >curves.csv
murk bench --parts error --cases box --sizes 125 --packets 1e3,2e3 --runs 1 --volume fixtures/puff.vdb --curves curves.csv -o plot.png
