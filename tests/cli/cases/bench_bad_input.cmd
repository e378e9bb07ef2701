murk bench plume.vdb
