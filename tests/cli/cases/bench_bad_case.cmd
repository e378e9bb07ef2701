murk bench --cases cloud,fog
