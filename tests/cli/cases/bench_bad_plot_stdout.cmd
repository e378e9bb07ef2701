murk bench -o -
