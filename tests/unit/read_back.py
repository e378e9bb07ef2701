#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Checks a VDB that murk wrote against its input: read_back.py INPUT GRID OUTPUT [MAXIMUM]"""
import itertools
import sys

import numpy
import pyopenvdb as vdb

MARGIN = 2


def matrix_of(grid):
    """Where the corners of a box go: pyopenvdb shows no matrix."""
    corners = itertools.product((0, 1000), repeat=3)
    return [grid.transform.indexToWorld(corner) for corner in corners]


def active_voxels(grid):
    voxels = {}
    for item in grid.iterOnValues():
        ranges = [range(a, b + 1) for a, b in zip(item.min, item.max)]
        for at in itertools.product(*ranges):
            voxels[at] = item.value
    return voxels


def dilated(voxels, margin):
    if not voxels:
        return set()
    places = numpy.array(sorted(voxels))
    low = places.min(axis=0) - margin
    size = places.max(axis=0) - low + margin + 1
    mask = numpy.zeros(size, dtype=bool)
    mask[tuple((places - low).T)] = True
    for axis in range(3):
        spread = mask.copy()
        for step in range(1, margin + 1):
            ahead = [slice(None)] * 3
            behind = [slice(None)] * 3
            ahead[axis], behind[axis] = slice(step, None), slice(None, -step)
            spread[tuple(ahead)] |= mask[tuple(behind)]
            spread[tuple(behind)] |= mask[tuple(ahead)]
        mask = spread
    return {tuple(int(c) for c in place + low) for place in numpy.argwhere(mask)}


def check(condition, text):
    if not condition:
        sys.exit("read_back: " + text)


def check_fog(grid, source, name):
    check(grid.gridClass == vdb.GridClass.FOG_VOLUME, name + ": not a fog volume")
    check(not numpy.any(grid.background), name + ": background is not 0")
    check(matrix_of(grid) == matrix_of(source), name + ": another transform")
    leaf_voxels = grid.leafCount() * 512
    check(grid.activeVoxelCount() <= leaf_voxels, name + ": tiles instead of leaf voxels")
    for at, value in active_voxels(grid).items():
        check(numpy.all(numpy.isfinite(value)) and numpy.min(value) >= 0, f"{name}: {value} at {at}")


def main(source_path, source_name, path, maximum=None):
    source = vdb.read(source_path, source_name)
    grids = {grid.name: grid for grid in vdb.readAll(path)[0]}
    metadata = vdb.readMetadata(path)
    check("radiosity" in grids, "no grid radiosity")
    radiosity = grids.pop("radiosity")
    check_fog(radiosity, source, "radiosity")
    inside, lit = active_voxels(source), active_voxels(radiosity)
    check(set(lit) == dilated(inside, MARGIN), "radiosity: not the input's voxels and two beyond")
    if maximum is not None:
        check(max(lit.values(), default=0) <= float(maximum), "radiosity: above the maximum")
    passed = grids.pop(source.name, None)
    if passed is not None:
        check(active_voxels(passed) == inside, source.name + ": changed")
        check(matrix_of(passed) == matrix_of(source), source.name + ": another transform")
        for key, value in source.metadata.items():
            if not key.startswith("file_"):
                check(passed.metadata.get(key) == value, f"{source.name}: metadata {key} changed")
    for name, grid in grids.items():
        check(name in ("emission_coefficient", "extinction", "albedo"), name + ": unexpected")
        check_fog(grid, source, name)
        check(set(active_voxels(grid)) == set(inside), name + ": other voxels than the input's")
    for key in ("murk_version", "units", "convention", "band", "sun_direction", "sun_irradiance",
                "sky_radiance", "tolerance", "error_estimate", "energy_balance"):
        check(key in metadata, "no file metadata " + key)
    check(metadata["units"] == "W/m^2" and metadata["band"] == "single", "other units or band")


if __name__ == "__main__":
    main(*sys.argv[1:])
