printf 'pictures,a path tracer,0.5,8.25\npictures,a path tracer,2\n' >curves.csv
murk bench --parts growth --cases box --sizes 125 --runs 1 --curves curves.csv -o plot.png
