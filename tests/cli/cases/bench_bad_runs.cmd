murk bench --runs 0
