#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the small volumes, scenes and pictures that the command-line cases read into a folder."""
import json
import math
import os
import struct
import subprocess
import sys

import pyopenvdb as vdb

EDGE = 8
folder = sys.argv[1]
os.makedirs(folder, exist_ok=True)


def path(name):
    return os.path.join(folder, name)


def grid(name, value, transform=None):
    """A float grid over EDGE^3 voxels of 0.1 m; value is a function of the distance to the middle."""
    result = vdb.FloatGrid()
    result.name = name
    result.transform = transform or vdb.createLinearTransform(voxelSize=0.1)
    accessor = result.getAccessor()
    for i in range(EDGE):
        for j in range(EDGE):
            for k in range(EDGE):
                r = math.dist((i, j, k), (3.5, 3.5, 3.5)) / 4
                if r < 1.1:
                    accessor.setValueOn((i, j, k), value(r))
    return result


def smoke(r):
    return 4 * (1.2 - r)


def with_one(value):
    result = grid("density", smoke)
    result.getAccessor().setValueOn((3, 3, 3), value)
    return result


vdb.write(path("puff.vdb"), grids=[grid("density", smoke)])
vdb.write(path("albedo.vdb"), grids=[grid("density", smoke), grid("good", lambda r: 0.8),
                                     grid("bad", lambda r: 1.5)])
vdb.write(path("nan.vdb"), grids=[with_one(math.nan)])
vdb.write(path("negative.vdb"), grids=[with_one(-1.0)])
empty = vdb.FloatGrid()
empty.name = "density"
vdb.write(path("empty.vdb"), grids=[empty])
frustum = vdb.createFrustumTransform(taper=0.5, depth=1.0, xyzMin=(0, 0, 0), xyzMax=(8, 8, 8))
vdb.write(path("frustum.vdb"), grids=[grid("density", smoke, frustum)])

tiles = vdb.FloatGrid(0.0)  # small as a file
tiles.name = "density"
tiles.fill((0, 0, 0), (511, 511, 511), 1.0)
vdb.write(path("tiles.vdb"), grids=[tiles])

coarse = vdb.createLinearTransform([[0.2, 0, 0, 0], [0, 0.2, 0, 0], [0, 0, 0.2, 0], [0.05, 0.05, 0.05, 1]])
ball = vdb.createLevelSetSphere(radius=0.4, center=(0.35, 0.35, 0.35), voxelSize=0.1)
ball.name = "surface"
mask = vdb.BoolGrid()
mask.name = "mask"
mask.transform = vdb.createLinearTransform(voxelSize=0.1)
mask.fill((0, 0, 0), (EDGE - 1, EDGE - 1, EDGE - 1), True)
vdb.write(path("odd.vdb"), grids=[
    grid("density", smoke), grid("density", lambda r: 2 * smoke(r)), grid("", smoke), grid("", smoke),
    grid("coarse", lambda r: 0.5, coarse), ball, mask])
vdb.write(path("surface.vdb"), grids=[ball])
vdb.write(path("flames.vdb"), grids=[grid("flames", smoke), grid("temperature", smoke)])
mask.name = "points"
vdb.write(path("points.vdb"), grids=[grid("density", smoke), mask])
with open(path("points.vdb"), "rb") as whole:
    known = whole.read()
with open(path("points.vdb"), "wb") as unknown:  # a type that no one knows
    unknown.write(known.replace(b"Tree_bool", b"Tree_pnts"))

os.makedirs(path("puffs"), exist_ok=True)
for frame in (1, 2, 4):  # puffs that grow; the third is missing, the fifth is no VDB
    vdb.write(path("puffs/puff.%04d.vdb" % frame),
              grids=[grid("density", lambda r: smoke(r) * (0.8 + 0.2 * frame))])
with open(path("puffs/puff.0005.vdb"), "w") as text:
    text.write("solid cube\n" * 40)
for frame in (9, 10, 11):
    vdb.write(path("puffs/loose.%d.vdb" % frame), grids=[grid("density", smoke)])

with open(path("puff.vdb"), "rb") as whole, open(path("truncated.vdb"), "wb") as part:
    part.write(whole.read()[:-400])
with open(path("text.vdb"), "w") as text:
    text.write("solid cube\n" * 40)


def scene(name, **keys):
    with open(path(name), "w") as out:
        json.dump({"medium": {"file": "puff.vdb"}, **keys}, out)


scene("puff.json", sun={"direction": [0.4, 0.3, -0.87], "irradiance": 1.0}, sky={"radiance": 0.1},
      ground={"extent": [[-1, -1], [2, 2]], "patches": [12, 12], "reflectance": 0.4},
      camera={"eye": [3, -3, 2], "target": [0.35, 0.35, 0.3], "fov": 35, "size": [40, 30]})
LIT = {"sun": {"direction": [0.4, 0.3, -0.87], "irradiance": 1.0}, "sky": {"radiance": 0.1},
       "camera": {"eye": [3, -3, 2], "target": [0.35, 0.35, 0.3], "size": [16, 12]}}


def sequence(name, file, **keys):
    scene(name, medium={"file": file, "extinction": {"grid": "density", "scale": 2}},
          **{**LIT, **keys})


sequence("puffs.json", "puffs/puff.####.vdb")
sequence("loose.json", "puffs/loose.$F.vdb")
for frame in (1, 2):
    sequence("cut_%02d.json" % frame, "puffs/puff.%04d.vdb",
             camera={**LIT["camera"], "eye": [3, -3, frame]})
sequence("cut_03.json", "puffs/puff.0001.vdb", camera={"fow": 40})
sequence("cut_04.json", "-")
sequence("plates.json", "puff.vdb", background="plate.$F2.pfm")
for frame in (1, 2):
    with open(path("plate.%02d.pfm" % frame), "wb") as image:
        image.write(b"Pf\n1 1\n-1.0\n" + struct.pack("<f", frame))
scene("unknown_top.json", grund={})
scene("unknown_camera.json", camera={"fow": 40})
scene("unknown_medium.json", medium={"file": "puff.vdb", "extinction": {"grid": "density", "scael": 2}})
scene("no_medium.json", medium=None)
scene("fov.json", camera={"fov": 190})
scene("zero_size.json", camera={"size": [0, 480]})
scene("sun_direction.json", sun={"direction": [0, 0, 0]})
scene("albedo.json", medium={"file": "puff.vdb", "albedo": 1.5})
scene("ground_size.json", ground={"reflectance": "ground.pfm", "patches": [4, 4]})
scene("ground_range.json", ground={"reflectance": "ground.pfm"})
scene("ground_inside.json", ground={"height": 0.5})
scene("uniform.json", medium={"file": "puff.vdb", "extinction": 1.5})
scene("extent.json", ground={"extent": [[1, 0], [0, 1]]})
scene("type.json", sky={"radiance": "bright"})
scene("eye_target.json", camera={"eye": [1, 2, 3], "target": [1, 2, 3]})
scene("no_image.json", ground={"reflectance": "missing.exr"})
scene("no_volume.json", medium={"file": "missing.vdb"})
scene("no_ground.json", sky={"radiance": 0.1})
with open(path("ground.pfm"), "wb") as image:  # 2 x 1 pixels, the second too bright
    image.write(b"Pf\n2 1\n-1.0\n" + struct.pack("<2f", 0.5, 1.5))
with open(path("mark.pfm"), "wb") as image:  # a bright square on a dark ground
    image.write(b"Pf\n6 6\n-1.0\n" + struct.pack("<36f", *(
        0.8 if 2 <= i % 6 < 4 and 2 <= i // 6 < 4 else 0.2 for i in range(36))))
scene("mark.json", medium={"file": "puff.vdb", "extinction": {"grid": "density", "scale": 0.5}},
      bands=[{"name": "R"}, {"name": "NIR", "extinction": {"grid": "density", "scale": 0.1}}],
      sun={"direction": [0, 0, -1], "irradiance": 1.0}, sky={"radiance": 0.1},
      ground={"extent": [[-0.25, -0.25], [0.95, 0.95]], "height": -0.1, "reflectance": "mark.pfm"},
      camera={"eye": [0.35, 0.34, 3], "target": [0.35, 0.35, 0], "fov": 20, "size": [40, 40]})
with open(path("syntax.json"), "w") as text:
    text.write('{"medium": {"file": "puff.vdb"},\n "sun": }\n')

# Pictures of 8 x 6 pixels in two bands: a target of 3 x 2 pixels at 2,1 through ever more smoke.
BANDS = "R:6e-07:7e-07,LWIR:8e-06:1.2e-05"
BAND_CHANNELS = ["%s.%s" % (band, channel) for band in ("R", "LWIR")
                 for channel in ("radiance", "inherent", "transmittance", "scattered", "emitted")]


def oiiotool(*arguments):
    subprocess.run(["oiiotool", *arguments], check=True)


def pixel(cl, red, thermal):
    """The channels where the light before the smoke is red and thermal [W/m^2/sr]; the smoke
    scatters 0.5 in the red band, and radiates as 290 K do in the thermal one."""
    values = []
    for inherent, depth, scattered, emitted in ((red, 2 * cl, 0.5, 0), (thermal, 0.3 * cl, 0, 32.517)):
        tau = math.exp(-depth)
        path_light = [(1 - tau) * scattered, (1 - tau) * emitted]
        values += [tau * inherent + sum(path_light), inherent, tau, *path_light]
    return "color=" + ",".join("%.9g" % value for value in [*values, cl])


def picture(name, cl, *attribute):
    oiiotool("--create", "8x6", "11", "--chnames", ",".join([*BAND_CHANNELS, "CL.Y"]),
             "--fill:" + pixel(cl, 2, 38.5004), "8x6",  # 300 K
             "--fill:" + pixel(cl, 3, 45.1149), "3x2+2+1",  # 310 K
             *attribute, "-d", "float", "-o", path(name))


os.makedirs(path("pics"), exist_ok=True)
for frame in (1, 2, 4):
    picture("pics/pic.%04d.exr" % frame, 0.5 * frame, "--attrib", "murk:bands", BANDS)
picture("pics/unknown.exr", 0.5, "--attrib", "murk:bands", "R:0:0,LWIR:0:0")
picture("pics/wrong.exr", 0.5, "--attrib", "murk:bands", "R")
picture("pics/lacking.exr", 0.5, "--attrib", "murk:bands", "NIR:0:0")
picture("pics/pic.0005.exr", 0.5)
oiiotool(path("pics/pic.0001.exr"), "--ch", ",".join(BAND_CHANNELS), "-o", path("pics/no_cl.1.exr"))
for name, place in (("target", "3x2+2+1"), ("target.1", "3x2+2+1"), ("target.2", "2x2+2+1"),
                    ("background", "8x5")):
    oiiotool("--create", "8x6", "3", "--fill:color=1,1,1", place, "-d", "uint8", "-o",
             path("pics/%s.png" % name))
oiiotool("--create", "4x3", "1", "-d", "uint8", "-o", path("pics/small.png"))
oiiotool("--create", "8x6", "1", "-d", "uint8", "-o", path("pics/black.png"))
