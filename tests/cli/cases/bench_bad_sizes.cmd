murk bench --sizes 1e4,10
