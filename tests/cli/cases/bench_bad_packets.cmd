murk bench --packets 0
