murk bench --parts error --volume fixtures/empty.vdb
