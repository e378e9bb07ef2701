murk bench --cases cloud,box --sizes 400,900 --runs 2 --tolerance 5% --parts growth,emptiness,threads --threads 2 -o plot.png
