# SPDX-License-Identifier: Apache-2.0
"""Renders a radiosity VDB of murk with Blender's Cycles.

    blender -b -P render.py -- RADIOSITY.vdb SCENE.json OUT.exr [OPTION]...

The volume absorbs with kappa x density and emits kappa x density x radiosity / pi; nothing scatters
any more. kappa and where voxels lie are in the file's metadata (python3-openvdb reads them), camera
and lights in the scene that murk solved. It prints a line "cycles SECONDS".
"""
import argparse
import os
import sys

import bpy
import pyopenvdb
from mathutils import Vector

sys.path.append(os.path.dirname(os.path.abspath(__file__)))
import stage


def parse():
    parser = argparse.ArgumentParser(prog="render.py", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("radiosity", help="what murk solve wrote")
    parser.add_argument("scene", help="the scene file that it solved")
    parser.add_argument("out", help="the picture, as .exr")
    parser.add_argument("--multiple-scattering", action="store_true",
                        help="leave the radiosity alone and trace paths from sun and sky")
    parser.add_argument("--samples", type=int, default=16, help="for each pixel (16)")
    parser.add_argument("--step-rate", type=float, default=1,
                        help="edge of a step through the medium, in voxels (1)")
    parser.add_argument("--seed", type=int, default=0, help="of the noise (0)")
    parser.add_argument("--voxels", choices=("center", "corner"),
                        help="what a voxel's index is, if not what the file says")
    parser.add_argument("--size", help="WIDTHxHEIGHT, if not what the scene says")
    parser.add_argument("--split", type=int, default=1,
                        help="cut each voxel into N^3 of the same value, beside the picture (1)")
    parser.add_argument("--blend", help="keep the scene as .blend")
    return parser.parse_args(sys.argv[sys.argv.index("--") + 1:])


def half_voxel(grid):
    """From the low corner of a voxel to its center [m]."""
    low = Vector(grid.transform.indexToWorld((0.0, 0.0, 0.0)))
    return Vector(grid.transform.indexToWorld((0.5, 0.5, 0.5))) - low


def kappa_of(path, metadata):
    """kappa_t per unit of the density [1/m]."""
    kappa = metadata.get("extinction_scale")
    if kappa is None:
        sys.exit(f"{path}: has no extinction_scale for all bands; solve with R, G and B or one "
                 "band, and an extinction from a grid")
    return kappa


def density_name(medium):
    extinction = medium.get("concentration", medium.get("extinction", "density"))
    name = extinction.get("grid") if isinstance(extinction, dict) else extinction
    return name if isinstance(name, str) else "density"


def volume_file(arguments, name):
    if arguments.split == 1:
        return arguments.radiosity
    fine = f"{arguments.out}.split.vdb"
    stage.split_voxels(arguments.radiosity, [name, "radiosity"], arguments.split, fine)
    return fine


def make_scene(arguments, description):
    medium, name = description["medium"], density_name(description["medium"])
    metadata = pyopenvdb.readMetadata(arguments.radiosity)
    kappa = kappa_of(arguments.radiosity, metadata)
    scene = stage.empty_scene()
    if arguments.multiple_scattering:
        if "sun" not in description:
            sys.exit(f"{arguments.scene}: names no sun; it needs one to scatter light of")
        material = stage.scattering_material(name, kappa, medium.get("albedo", 0.9))
        stage.add_light(scene, description)
    else:
        material = stage.radiosity_material(name, kappa)
    volume = stage.add_volume(volume_file(arguments, name), material)
    if (arguments.voxels or metadata["voxels"]) == "center":
        # Blender 3.4 draws the voxel (i, j, k) as the cell [i, i + 1] x ...
        volume.location = -half_voxel(pyopenvdb.readGridMetadata(arguments.radiosity, name))
    scene.cycles.volume_step_rate = arguments.step_rate
    if arguments.size:
        description["camera"]["size"] = [int(edge) for edge in arguments.size.split("x")]
    stage.add_camera(scene, description)
    return scene


def main():
    arguments = parse()
    scene = make_scene(arguments, stage.read_scene(arguments.scene))
    if arguments.blend:
        bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath(arguments.blend))
    seconds = stage.render(scene, arguments.samples, arguments.seed, arguments.out)
    print("cycles", seconds, flush=True)


main()
