murk info fixtures/frustum.vdb
