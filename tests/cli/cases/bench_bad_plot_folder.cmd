murk bench -o nowhere/plot.png
