# SPDX-License-Identifier: Apache-2.0
"""Renders the medium of a murk scene with Blender's Cycles: path tracing with multiple scattering.

    blender -b -P render.py -- SCENE.json OUT RUN...

A run is SAMPLES, SAMPLES:SEED or SAMPLES:SEED:SPLIT; its picture is OUT_RUN.exr, R = G = B the
radiance of the medium [W/m^2/sr] and A its opacity, and it prints a line "cycles RUN SECONDS".
SPLIT cuts each voxel into SPLIT^3 of the same density. Cycles interpolates densities linearly; with
ever smaller voxels that comes to densities that are constant in the voxels of the file, as murk has
them.
"""
import json
import math
import os
import sys
import time

import bpy
import numpy
import pyopenvdb
from mathutils import Vector


def split_voxels(path, grid, factor, out):
    source = pyopenvdb.read(path, grid)
    low, high = source.evalActiveVoxelBoundingBox()
    values = numpy.zeros([b - a + 1 for a, b in zip(low, high)], numpy.float32)
    source.copyToArray(values, ijk=low)
    for axis in range(3):
        values = values.repeat(factor, axis)
    fine = pyopenvdb.FloatGrid()
    fine.copyFromArray(values, ijk=tuple(factor * a for a in low))
    fine.name = grid
    fine.transform = pyopenvdb.createLinearTransform(source.transform.voxelSize()[0] / factor)
    pyopenvdb.write(out, grids=[fine])


def set_cycles(scene):
    scene.render.engine = "CYCLES"
    scene.render.use_persistent_data = True  # the time is that of rendering alone
    scene.render.film_transparent = True
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.max_bounces = cycles.volume_bounces = 128
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.light_sampling_threshold = 0
    cycles.pixel_filter_type = "BOX"
    cycles.filter_width = 1
    image = scene.render.image_settings
    image.file_format, image.color_mode, image.color_depth = "OPEN_EXR", "RGBA", "32"


def add_medium(path, medium):
    bpy.ops.object.volume_import(filepath=path)
    volume = bpy.context.object
    volume.rotation_euler = volume.location = (0, 0, 0)
    volume.data.render.clipping = 0
    volume.data.render.precision = "FULL"
    material = bpy.data.materials.new("medium")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    density = nodes.new("ShaderNodeAttribute")
    density.attribute_name = medium["extinction"]["grid"]

    def part(kind, color, factor):
        shader, scaled = nodes.new(kind), nodes.new("ShaderNodeMath")
        scaled.operation = "MULTIPLY"
        scaled.inputs[1].default_value = factor * medium["extinction"]["scale"]
        shader.inputs["Color"].default_value = (color, color, color, 1)
        links.new(density.outputs["Fac"], scaled.inputs[0])
        links.new(scaled.outputs[0], shader.inputs["Density"])
        return shader.outputs[0]

    both, output = nodes.new("ShaderNodeAddShader"), nodes.new("ShaderNodeOutputMaterial")
    links.new(part("ShaderNodeVolumeScatter", 1, medium["albedo"]), both.inputs[0])
    links.new(part("ShaderNodeVolumeAbsorption", 0, 1 - medium["albedo"]), both.inputs[1])
    links.new(both.outputs[0], output.inputs["Volume"])
    material.cycles.volume_sampling = "MULTIPLE_IMPORTANCE"
    volume.data.materials.append(material)


def add_light(scene, description):
    sun = bpy.data.lights.new("sun", "SUN")
    sun.energy, sun.angle = description["sun"]["irradiance"], 0
    place = bpy.data.objects.new("sun", sun)
    place.rotation_euler = look(Vector(description["sun"]["direction"]))
    scene.collection.objects.link(place)
    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    sky = scene.world.node_tree.nodes["Background"]
    sky.inputs["Color"].default_value = (1, 1, 1, 1)
    sky.inputs["Strength"].default_value = description["sky"]["radiance"]


def add_camera(scene, description):
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit, camera.angle = "VERTICAL", math.radians(description["fov"])
    place = bpy.data.objects.new("camera", camera)
    place.location = description["eye"]
    place.rotation_euler = look(Vector(description["target"]) - Vector(description["eye"]))
    scene.collection.objects.link(place)
    scene.camera = place
    scene.render.resolution_x, scene.render.resolution_y = description["size"]
    scene.render.resolution_percentage = 100


def look(along):
    return along.to_track_quat("-Z", "Y").to_euler()


def make_scene(path, split, out):
    with open(path) as file:
        description = json.load(file)
    medium = description["medium"]
    volume = os.path.join(os.path.dirname(os.path.abspath(path)), medium["file"])
    if split > 1:
        fine = f"{out}_split{split}.vdb"
        split_voxels(volume, medium["extinction"]["grid"], split, fine)
        volume = os.path.abspath(fine)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    set_cycles(scene)
    add_medium(volume, medium)
    add_light(scene, description)
    add_camera(scene, description["camera"])
    return scene


def render(scene, samples, seed, path):
    scene.cycles.samples, scene.cycles.seed = samples, seed
    scene.render.filepath = os.path.abspath(path)
    start = time.perf_counter()
    bpy.ops.render.render(write_still=True)
    return time.perf_counter() - start


def main(path, out, *runs):
    before = None
    for run in runs:
        given = [int(text) for text in run.split(":")]
        samples, seed, split = given + [0, 1][len(given) - 1:]
        picture = f"{out}_{run.replace(':', '_')}.exr"
        if split != before:
            scene = make_scene(path, split, out)
            render(scene, 1, 0, picture)  # reads the volume
            before = split
        print("cycles", run, render(scene, samples, seed, picture), flush=True)


main(*sys.argv[sys.argv.index("--") + 1:])
