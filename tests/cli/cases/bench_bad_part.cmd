murk bench --parts growth,speed
