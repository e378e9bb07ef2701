trap 'rm v.vdb' EXIT
/usr/bin/python3 -c '
import pyopenvdb as vdb
def grid(name, transform):
    result = vdb.FloatGrid()
    result.name, result.transform = name, transform
    result.fill((0, 0, 0), (3, 3, 3), 0.5)
    return result
size = lambda edge: vdb.createLinearTransform(voxelSize=edge)
vdb.write("v.vdb", grids=[grid("density", vdb.createLinearTransform([[1, 0, 0, 0], [0.5, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]))])'
murk image v.vdb  -o a.exr
