murk bench --parts error --volume nowhere.vdb
