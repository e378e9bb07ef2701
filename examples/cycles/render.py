# SPDX-License-Identifier: Apache-2.0
"""Renders the medium of a murk scene with Blender's Cycles: path tracing with multiple scattering.

    blender -b -P render.py -- SCENE.json OUT RUN...

A run is SAMPLES, SAMPLES:SEED or SAMPLES:SEED:SPLIT; its picture is OUT_RUN.exr, R = G = B the
radiance of the medium [W/m^2/sr] and A its opacity, and it prints a line "cycles RUN SECONDS".
SPLIT cuts each voxel into SPLIT^3 of the same density: see split_voxels().
"""
import os
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "../blender"))
import stage


def make_scene(path, split, out):
    description = stage.read_scene(path)
    medium = description["medium"]
    extinction = medium["extinction"]
    volume = os.path.join(os.path.dirname(os.path.abspath(path)), medium["file"])
    if split > 1:
        fine = f"{out}_split{split}.vdb"
        stage.split_voxels(volume, [extinction["grid"]], split, fine)
        volume = fine
    scene = stage.empty_scene()
    stage.add_volume(volume, stage.scattering_material(extinction["grid"], extinction["scale"],
                                                       medium["albedo"]))
    stage.add_light(scene, description)
    stage.add_camera(scene, description)
    return scene


def main(path, out, *runs):
    before = None
    for run in runs:
        given = [int(text) for text in run.split(":")]
        samples, seed, split = given + [0, 1][len(given) - 1:]
        picture = f"{out}_{run.replace(':', '_')}.exr"
        if split != before:
            scene = make_scene(path, split, out)
            stage.render(scene, 1, 0, picture)  # reads the volume
            before = split
        print("cycles", run, stage.render(scene, samples, seed, picture), flush=True)


main(*sys.argv[sys.argv.index("--") + 1:])
