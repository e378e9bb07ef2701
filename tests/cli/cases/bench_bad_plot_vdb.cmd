murk bench -o plot.vdb
