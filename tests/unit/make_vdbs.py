#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes odd VDB files, such as real ones are, into a folder: make_vdbs.py FOLDER"""
import math
import os
import sys

import numpy
import pyopenvdb as vdb


def grid_of(name, values, origin=(0, 0, 0), background=0.0, grid_class=vdb.GridClass.FOG_VOLUME):
    grid = vdb.FloatGrid(background)
    grid.copyFromArray(numpy.asarray(values, dtype=numpy.float32), ijk=origin)
    grid.name = name
    grid.gridClass = grid_class
    return grid


def scale(*sizes):
    return vdb.createLinearTransform(
        [[sizes[0], 0, 0, 0], [0, sizes[1], 0, 0], [0, 0, sizes[2], 0], [0, 0, 0, 1]])


def rotated(sizes, angle, shift):
    """Non-cubic voxels, turned about z, moved; rows as OpenVDB wants them."""
    c, s = math.cos(angle), math.sin(angle)
    return vdb.createLinearTransform([[c * sizes[0], s * sizes[0], 0, 0],
                                      [-s * sizes[1], c * sizes[1], 0, 0],
                                      [0, 0, sizes[2], 0], [*shift, 1]])


def ramp(n=4):
    return numpy.arange(1, n**3 + 1, dtype=numpy.float32).reshape(n, n, n) / n**3


def write(folder, name, grids, metadata=None):
    vdb.write(os.path.join(folder, name + ".vdb"), grids=grids, metadata=metadata or {})


def main(folder):
    os.makedirs(folder, exist_ok=True)

    tiles = vdb.FloatGrid(0.0)
    tiles.name = "density"
    tiles.fill((0, 0, 0), (15, 7, 7), 0.5)
    tiles.fill((128, 0, 0), (255, 127, 127), 0.25)
    tiles.fill((-3, -2, -1), (-1, -1, -1), 2.0)
    write(folder, "tiles", [tiles])

    huge = vdb.FloatGrid(0.0)
    huge.name = "density"
    huge.fill((0, 0, 0), (8191, 4095, 4095), 1.0)
    write(folder, "huge_tiles", [huge])

    half = grid_of("density", ramp())
    half.saveFloatAsHalf = True
    write(folder, "half", [half])

    write(folder, "same_names", [grid_of("density", numpy.zeros((2, 2, 2)) + 1e-9),
                                 grid_of("density", ramp()), grid_of("density", ramp(5))])
    write(folder, "unnamed", [grid_of("", ramp())])
    write(folder, "two_unnamed", [grid_of("", ramp()), grid_of("", ramp(3))])

    turned = grid_of("density", ramp(9), origin=(-5, 3, 7))
    turned.transform = rotated((0.1, 0.2, 0.05), 0.7, (10.0, -3.0, 2.5))
    write(folder, "rotated", [turned])

    sheared = grid_of("density", ramp())
    sheared.transform = vdb.createLinearTransform(
        [[1, 0, 0, 0], [0.5, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    write(folder, "sheared", [sheared])

    frustum = grid_of("density", ramp())
    frustum.transform = vdb.createFrustumTransform((0, 0, 0), (10, 10, 10), 0.5, 10.0, 0.1)
    write(folder, "frustum", [frustum])

    bad = ramp()
    bad[0, 0, 0], bad[0, 0, 1], bad[0, 0, 2] = math.nan, math.inf, -math.inf
    bad[0, 0, 3], bad[0, 1, 0] = -1.0, 0.0
    invalid = vdb.FloatGrid(0.0)
    invalid.name = "density"
    access = invalid.getAccessor()
    for at in numpy.ndindex(bad.shape):
        access.setValueOn(at, float(bad[at]))
    write(folder, "invalid", [invalid])

    empty = vdb.FloatGrid(0.0)
    empty.name = "density"
    empty.gridClass = vdb.GridClass.FOG_VOLUME
    write(folder, "empty", [empty])
    write(folder, "no_grids", [])

    zeros = vdb.FloatGrid(0.0)
    zeros.name = "density"
    access = zeros.getAccessor()
    for at in numpy.ndindex(8, 8, 8):
        access.setValueOn(at, 0.5 if at[0] >= 6 else 0.0)
    write(folder, "active_zeros", [zeros])

    background = grid_of("density", ramp(), background=3.0)
    write(folder, "background", [background])

    velocity = vdb.Vec3SGrid((0, 0, 0))
    velocity.name = "velocity"
    velocity.fill((0, 0, 0), (3, 3, 3), (1, 2, 3))
    mask = vdb.BoolGrid(False)
    mask.name = "mask"
    mask.fill((0, 0, 0), (3, 3, 3), True)
    sphere = vdb.createLevelSetSphere(radius=5.0, voxelSize=1.0)
    sphere.name = "surface"
    write(folder, "beside", [velocity, mask, sphere, grid_of("smoke", ramp())])

    ball = vdb.createLevelSetSphere(radius=10.0, center=(0.1, 0.2, 0.3), voxelSize=0.5)
    ball.name = "surface"
    write(folder, "ball", [ball])
    named = ball.deepCopy()
    named.name = "density"
    write(folder, "named_ball", [named, grid_of("smoke", ramp())])
    for name, last in (("filled", 127), ("overfilled", 4095)):
        filled = vdb.FloatGrid(3.0)  # inside are inactive tiles of 128^3 and of 4096^3 voxels
        filled.name = "surface"
        filled.gridClass = vdb.GridClass.LEVEL_SET
        filled.fill((0, 0, 0), (last, last, last), -3.0, False)
        filled.getAccessor().setValueOn((128, 0, 0), 0.25)
        filled.getAccessor().setValueOn((128, 0, 1), math.nan)
        write(folder, name, [filled])

    write(folder, "flames", [grid_of("flames", ramp()), grid_of("temperature", ramp())])
    write(folder, "voxel_fog", [grid_of("temperature", ramp()),
                                grid_of("voxel_fog_density", ramp())])
    write(folder, "only", [grid_of("Gas", ramp())])
    write(folder, "several", [grid_of("a", ramp()), grid_of("b", ramp())])

    medium = [grid_of("density", ramp()), grid_of("scatter", ramp()),
              grid_of("glow", 10 * ramp()), grid_of("bright", 2 * ramp()),
              grid_of("elsewhere", ramp())]
    for grid in medium:
        grid.transform = scale(0.5, 0.5, 0.25)
    medium[-1].transform = scale(0.5, 0.5, 0.5)
    write(folder, "medium", medium)

    lit = [grid_of("density", ramp()), grid_of("radiosity", numpy.zeros((8, 8, 8)) + 2.0,
                                               origin=(-2, -2, -2))]
    write(folder, "lit", lit)
    write(folder, "unlit", [grid_of("density", ramp()), grid_of("radiosity", ramp(3))])

    coloured = vdb.Vec3SGrid((0, 0, 0))
    coloured.name = "radiosity"
    coloured.fill((-8, -8, -8), (15, 15, 15), (1, 2, 3))
    write(folder, "coloured", [grid_of("density", ramp()), coloured])
    coloured.transform = frustum.transform
    write(folder, "coloured_frustum", [grid_of("density", ramp()), coloured])


if __name__ == "__main__":
    main(sys.argv[1])
