#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the VDB of several bands that test_volume_bands.c wrote:
read_bands.py INPUT GRID OUTPUT half|full shared|own NAME=FACTOR...
The last but the names: whether the bands share the extinction."""
import math
import sys

import pyopenvdb as vdb

from read_back import MARGIN, active_voxels, check, check_fog, dilated

OWN = ("sun_irradiance", "sky_radiance", "error_estimate", "tolerance_reached", "energy_emitted",
       "energy_sun", "energy_diffuse", "energy_absorbed", "energy_escaped", "energy_balance")
ONCE = ("murk_version", "command", "units", "convention", "sun_direction", "zones", "patches",
        "tolerance")
COLOURS = ["R", "G", "B"]


def take(grids, name, value_type, half, source):
    check(name in grids, "no grid " + name)
    grid = grids.pop(name)
    check(grid.valueTypeName == value_type, f"{name}: of type {grid.valueTypeName}")
    check(grid.saveFloatAsHalf == half, name + ": half floats where none are meant, or not")
    check_fog(grid, source, name)
    return active_voxels(grid)


def take_bands(grids, quantity, bands, half, source):
    """The values of each band, whichever grids they are in."""
    coloured = set(COLOURS) <= set(bands)
    values = {}
    if coloured:
        voxels = take(grids, quantity, "vec3s", half, source)
        for c, band in enumerate(COLOURS):
            values[band] = {at: value[c] for at, value in voxels.items()}
    for band in bands:
        if band not in values:
            values[band] = take(grids, f"{quantity}_{band}", "float", half, source)
    return values


def lit_values(places):
    """As make_solution() has them: 1 + slot / 512 + number of the brick."""
    bricks = sorted({tuple(c >> 3 for c in at) for at in places})
    number = {brick: n for n, brick in enumerate(bricks)}
    return {at: 1 + ((at[0] & 7) * 64 + (at[1] & 7) * 8 + (at[2] & 7)) / 512 +
            number[tuple(c >> 3 for c in at)] for at in places}


def check_values(values, wanted, half, name):
    check(set(values) == set(wanted), name + ": other voxels")
    for at, value in values.items():
        check(math.isclose(value, wanted[at], rel_tol=4e-3 if half else 1e-5, abs_tol=1e-5),
              f"{name}: {value} at {at}, not {wanted[at]}")


def check_metadata(metadata, bands):
    check(metadata["band"] == ",".join(bands), "other bands: " + metadata["band"])
    for key in ONCE:
        check(key in metadata, "no file metadata " + key)
    for key in OWN:
        check(key not in metadata, f"file metadata {key} for all bands")
        for band in bands:
            check(f"{key}_{band}" in metadata, f"no file metadata {key}_{band}")
    for band, factor in bands.items():
        check(metadata["sun_irradiance_" + band] == 2 * factor, band + ": another sun")
        check(metadata["sky_radiance_" + band] == 0.5, band + ": another sky")
        check(metadata["error_estimate_" + band] == factor / 1024, band + ": another error")
        check(metadata["tolerance_reached_" + band] == ("yes" if factor < 5 else "no"),
              band + ": tolerance reached or not")


def main(source_path, source_name, path, storage, extinctions, *names):
    half = storage == "half"
    bands = {name: float(factor) for name, factor in (each.split("=") for each in names)}
    source = vdb.read(source_path, source_name)
    grids = {grid.name: grid for grid in vdb.readAll(path)[0]}
    inside = active_voxels(source)
    check(active_voxels(grids.pop(source_name)) == inside, source_name + ": changed")
    radiosity = take_bands(grids, "radiosity", bands, half, source)
    emission = take_bands(grids, "emission_coefficient", bands, half, source)
    albedo = take_bands(grids, "albedo", bands, half, source)
    if extinctions == "shared":
        one = take(grids, "extinction", "float", half, source)
        extinction = {band: one for band in bands}
    else:
        extinction = take_bands(grids, "extinction", bands, half, source)
    check(not grids, "unexpected grids: " + ", ".join(grids))
    lit = lit_values(dilated(inside, MARGIN))
    for n, (band, factor) in enumerate(bands.items()):
        check_values(radiosity[band], {at: factor * b for at, b in lit.items()}, half, band)
        kappa = {at: value * (1 if extinctions == "shared" or band != "LWIR" else 0.5)
                 for at, value in inside.items()}
        check_values(extinction[band], kappa, half, "extinction of " + band)
        check_values(emission[band], {at: k * factor * lit[at] / math.pi
                                      for at, k in kappa.items()}, half, "emission of " + band)
        check_values(albedo[band], {at: 0.9 - n / 8 if k > 0 else 0 for at, k in kappa.items()},
                     half, "albedo of " + band)
    check_metadata(vdb.readMetadata(path), bands)


if __name__ == "__main__":
    main(*sys.argv[1:])
