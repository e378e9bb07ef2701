#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What murk writes, as vdb_print, pyopenvdb, oiiotool and readers of USD find it:
other_tools.py MURK FIXTURES"""
import itertools
import json
import math
import os
import re
import subprocess
import sys
import tempfile

import pyopenvdb as vdb

import usda

BANDS = ("R", "G", "B", "LWIR")
SCALE = 2
CAMERA = {"eye": [3, -3, 2], "target": [0.35, 0.35, 0.3], "fov": 35, "size": [40, 30]}
SUN = [0.4, 0.3, -0.87]
murk, fixtures = (os.path.abspath(path) for path in sys.argv[1:])


def run(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    assert done.returncode == 0, f"{' '.join(command)}: {done.stdout}"
    return done.stdout


def near(a, b, tolerance=1e-5):
    return math.isclose(a, b, rel_tol=tolerance, abs_tol=tolerance)


def write_scene(path, bands):
    scene = {"medium": {"file": os.path.join(fixtures, "puff.vdb"), "albedo": 0.8,
                        "extinction": {"grid": "density", "scale": SCALE}, "voxels": "corner"},
             "sun": {"direction": SUN, "irradiance": 1.0}, "sky": {"radiance": 0.1},
             "ground": {"extent": [[-1, -1], [2, 2]], "patches": [12, 10], "reflectance": 0.4},
             "camera": CAMERA}
    if bands:
        scene["bands"] = [{"name": name, "sun": {"irradiance": n + 1.0}}
                          for n, name in enumerate(bands)]
    with open(path, "w") as file:
        json.dump(scene, file)


def image(bands, *options):
    """Writes everything that murk can write, into the working folder."""
    write_scene("scene.json", bands)
    run(murk, "image", "scene.json", "-q", "--threads", "1", "--radiosity", "all.vdb",
        "--emission-coefficient", "--extinction-grid", "--albedo-grid", "--usd", "all.usda",
        "--ground-radiosity", "ground.exr", "-o", "all.exr", "--preview", "all.png", *options)


def grids_of(quantities, bands):
    """Names and types of the grids, as README.md has them."""
    grids = {"density": "float", "extinction": "float"}
    for quantity in quantities:
        grids[quantity] = "vec3s" if bands else "float"
        if bands:
            grids[quantity + "_LWIR"] = "float"
    return grids


def check_values(grids, bands, half):
    """emission_coefficient = kappa_t B / pi, kappa_t = scale x density, albedo, voxel by voxel."""
    tolerance = 4e-3 if half else 1e-5
    for suffix in ("", "_LWIR") if bands else ("",):
        of = {name: grids[name + suffix].getConstAccessor()
              for name in ("radiosity", "emission_coefficient", "albedo")}
        kappa = grids["extinction"].getConstAccessor()
        for item in grids["density"].citerOnValues():
            at = item.min
            assert near(kappa.getValue(at), SCALE * item.value, tolerance), "extinction"
            b, e, a = (of[name].getValue(at) for name in ("radiosity", "emission_coefficient",
                                                          "albedo"))
            for x, y, z in zip(*(v if isinstance(v, tuple) else (v,) for v in (b, e, a))):
                assert x > 0 and near(y, kappa.getValue(at) * x / math.pi, tolerance), "emission"
                assert near(z, 0.8, tolerance), "albedo"


def check_vdb(bands, half):
    wanted = grids_of(("radiosity", "emission_coefficient", "albedo"), bands)
    grids, metadata = vdb.readAll("all.vdb")
    grids = {grid.name: grid for grid in grids}
    assert {name: grid.valueTypeName for name, grid in grids.items()} == wanted, grids
    for name, grid in grids.items():
        if name != "density":  # which is passed on as it is
            assert grid.gridClass == vdb.GridClass.FOG_VOLUME, name + ": no fog volume"
            assert grid.saveFloatAsHalf == half, name + ": half or not"
    assert metadata["extinction_scale"] == SCALE and metadata["voxels"] == "corner"
    assert metadata["band"] == (",".join(bands) if bands else "single")
    check_values(grids, bands, half)
    return grids


def check_vdb_print(grids, bands):
    """vdb_print exits with 0 whatever it finds; what it says must be what pyopenvdb found."""
    said = run("vdb_print", "-l", "-m", "all.vdb")
    metadata = dict(re.findall(r"^(\w+): (.*)$", said, re.MULTILINE))
    assert metadata["band"] == (",".join(bands) if bands else "single"), said
    assert metadata["units"] == "W/m^2" and metadata["extinction_scale"] == str(SCALE), said
    assert metadata["sun_direction"] == "0.4 0.3 -0.87", said
    parts = re.split(r"^Name: (.*)$", said, flags=re.MULTILINE)
    parts = dict(zip(parts[1::2], parts[2::2]))
    assert set(parts) == set(grids), sorted(parts)
    for name, grid in grids.items():
        low, high = grid.evalActiveVoxelBoundingBox()
        ours = ("class: fog volume", f"is_saved_as_half_float: {str(grid.saveFloatAsHalf).lower()}")
        for line in (f"Number of active voxels: *{grid.activeVoxelCount():,}",
                     re.escape(f"voxels: {list(low)} -> {list(high)}"), "voxel size: 0.1",
                     *(ours if name != "density" else ()), f"Type: Tree_{grid.valueTypeName}_5_4_3"):
            assert re.search(line, parts[name]), f"{name}: no {line} in {parts[name]}"


def statistics(path):
    """oiiotool's statistics by channel: {"R": {"Min": ...}}, with "size" and "type"."""
    said = run("oiiotool", "--info", "-v", "--stats", path)
    size = re.search(r":\s+(\d+) x\s+(\d+), (\d+) channel, (\w+) (\w+)", said)
    channels = re.search(r"channel list: (.*)", said).group(1).split(", ")
    found = {name: {} for name in channels}
    for key, values in re.findall(r"(?:Stats )?(\w+): ([-\d. einfa]+?)(?: \(.*\))?$", said,
                                  re.MULTILINE):
        values = values.split()
        if len(values) == len(channels):
            for name, value in zip(channels, values):
                found[name][key] = float(value)
    return (int(size.group(1)), int(size.group(2))), size.group(4), found


def check_picture(bands):
    size, kind, channels = statistics("all.exr")
    assert size == tuple(CAMERA["size"]) and kind == "float", (size, kind)
    wanted = {"R", "G", "B", "A", "Z", "transmittance.Y", *(f"{part}.{c}" for c in "RGB"
                                                           for part in ("path", "surface"))}
    for band in bands:
        wanted |= {f"{band}.{name}" for name in ("radiance", "surface", "inherent", "scattered",
                                                 "emitted", "transmittance", "temperature")}
    assert set(channels) == wanted, sorted(channels)
    for name, found in channels.items():
        assert found["NanCount"] == 0 or name.endswith("temperature"), name + ": not numbers"
        assert found["InfCount"] == 0 or name == "Z", name + ": infinite"
        assert found["Min"] >= 0, name + ": negative"
    assert near(channels["A"]["Max"], 1 - channels["transmittance.Y"]["Min"])
    assert channels["A"]["Max"] > 0.1 and channels["R"]["Max"] > 0.01
    for c in "RGB":
        means = [channels[name + c]["Avg"] for name in ("", "path.", "surface.")]
        assert near(means[0], means[1] + means[2]), "R is not path.R + surface.R"
    size, kind, channels = statistics("all.png")
    assert size == tuple(CAMERA["size"]) and kind == "uint8" and set(channels) == set("RGB")
    assert max(found["Max"] for found in channels.values()) > 100, "a dark PNG"


def check_ground(bands):
    size, kind, channels = statistics("ground.exr")
    assert size == (12, 10) and kind == "float" and set(channels) == set(bands or "Y"), channels
    for n, found in enumerate(channels[name] for name in bands or "Y"):
        # at least from the sky alone, at most of all sunlight and twice the sky's
        assert 0.4 * 0.1 * math.pi / 2 < found["Min"] < found["Max"] < 0.4 * (n + 1 + 0.2 * math.pi)


def check_camera(camera):
    p = camera.properties
    rows = p["xformOp:transform"]
    x, y, z, eye = (row[:3] for row in rows)
    along = [t - e for t, e in zip(CAMERA["target"], CAMERA["eye"])]
    length = math.dist(CAMERA["target"], CAMERA["eye"])
    assert [row[3] for row in rows] == [0, 0, 0, 1] and list(eye) == CAMERA["eye"]
    assert all(near(-c * length, a) for c, a in zip(z, along)), "it does not look along -z"
    for a, b in itertools.combinations_with_replacement((x, y, z), 2):
        assert near(sum(map(lambda u, v: u * v, a, b)), a is b), "no rotation"
    assert near(x[2], 0) and y[2] > 0, "it does not stand upright"
    fov = 2 * math.degrees(math.atan(p["verticalAperture"] / 2 / p["focalLength"]))
    assert near(fov, CAMERA["fov"]) and near(p["horizontalAperture"] / p["verticalAperture"], 4 / 3)


def check_usda(grids, bands):
    metadata, world = usda.read("all.usda")
    assert metadata["upAxis"] == "Z" and metadata["metersPerUnit"] == 1
    assert "startTimeCode" not in metadata
    prims = world.children
    assert list(prims) == ["Medium", "Camera", "Sun", "Sky"], list(prims)
    volume = prims["Medium"]
    assert volume.metadata["customData"]["murk"]["extinction_scale"] == SCALE
    assert set(volume.children) == set(grids), "other fields than grids"
    for name, field in volume.children.items():
        assert volume.properties["field:" + name] == "/World/Medium/" + name
        vector = grids[name].valueTypeName == "vec3s"
        assert field.properties["filePath"] == "./all.vdb"
        assert field.properties["fieldName"] == name
        assert field.properties.get("fieldClass") == (None if name == "density" else "fogVolume")
        assert field.properties["fieldDataType"] == ("float3" if vector else "float")
        assert field.properties.get("vectorDataRoleHint") == ("Color" if vector else None)
    # Radiosity covers two voxels of 0.1 m beyond the density; corner voxels are moved by half of one.
    low, high = grids["radiosity"].evalActiveVoxelBoundingBox()
    extent = volume.properties["extent"]
    for place, index, half in zip(extent, (low, high), (-0.5, 0.5)):
        assert all(near(p, 0.1 * (i + half)) for p, i in zip(place, index)), extent
    assert all(near(c, 0.05) for c in volume.properties["xformOp:translate"])
    check_camera(prims["Camera"])
    z = prims["Sun"].properties["xformOp:transform"][2]
    length = math.hypot(*SUN)
    assert all(near(-c, s / length) for c, s in zip(z, SUN)), "the sun shines elsewhere"
    assert prims["Sun"].properties["inputs:color"] == ((1, 2, 3) if bands else (1, 1, 1))
    assert all(near(c, 0.1) for c in prims["Sky"].properties["inputs:color"])


def check_usda_of_frame():
    os.mkdir("stages")
    run(murk, "solve", os.path.join(fixtures, "puffs.json"), "--frames", "2", "-q", "--threads", "1",
        "-o", "lit.####.vdb", "--usd", "stages/lit.$F.usda")
    metadata, world = usda.read("stages/lit.2.usda")
    assert metadata["startTimeCode"] == metadata["endTimeCode"] == 2
    volume = world.children["Medium"]
    assert list(volume.properties["extent.timeSamples"]) == [2]
    assert "xformOp:translate" not in volume.properties  # its voxels are centered on their index
    for name in ("density", "radiosity"):
        properties = volume.children[name].properties
        assert properties["filePath.timeSamples"] == {2: "../lit.0002.vdb"} and \
            "filePath" not in properties


def main():
    for bands, options in ((BANDS, ()), (BANDS, ("--half",)), ((), ()), ((), ("--half",))):
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            image(bands, *options)
            grids = check_vdb(bands, "--half" in options)
            check_vdb_print(grids, bands)
            check_picture(bands)
            check_ground(bands)
            check_usda(grids, bands)
            if not bands and not options:
                check_usda_of_frame()
            os.chdir("/")


main()
