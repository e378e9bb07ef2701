murk bench --parts error --curves missing.csv -o a.png
