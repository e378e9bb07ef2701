murk info volumes/plume128_f038.vdb
