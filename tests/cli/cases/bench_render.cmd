murk bench --cases box --sizes 125 --runs 1 --parts growth --render
