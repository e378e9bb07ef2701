murk info fixtures/surface.vdb --grid surface --scale 2
