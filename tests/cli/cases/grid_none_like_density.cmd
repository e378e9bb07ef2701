trap 'rm v.vdb' EXIT
/usr/bin/python3 -c '
import pyopenvdb as vdb
def grid(name, transform):
    result = vdb.FloatGrid()
    result.name, result.transform = name, transform
    result.fill((0, 0, 0), (3, 3, 3), 0.5)
    return result
size = lambda edge: vdb.createLinearTransform(voxelSize=edge)
vdb.write("v.vdb", grids=[grid("heat", size(0.1)), grid("fuel", size(0.1))])'
murk image v.vdb  -o a.exr
