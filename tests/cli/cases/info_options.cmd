murk info fixtures/albedo.vdb --grid good --albedo bad --voxel-size 0.2 --voxels corner --threads 1 -q
