# SPDX-License-Identifier: Apache-2.0
"""A murk scene in Blender: camera, sun, sky and medium as the scene file has them.

Module of render.py and ../cycles/render.py. Pictures hold the medium alone, R,G,B its radiance
[W/m^2/sr] and A its opacity, as those of murk render --no-background do.
"""
import json
import math
import os
import sys
import time

import bpy
import numpy
import pyopenvdb
from mathutils import Matrix, Vector


def read_scene(path):
    with open(path) as file:
        return json.load(file)


def set_cycles(scene):
    scene.render.engine = "CYCLES"
    scene.render.use_persistent_data = True  # a second picture takes the time of rendering alone
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


def add_volume(path, fill_material):
    """The volume of a VDB file, with a material that fill_material(nodes, links) makes."""
    bpy.ops.object.volume_import(filepath=os.path.abspath(path))
    volume = bpy.context.object
    volume.rotation_euler = volume.location = (0, 0, 0)
    volume.data.render.clipping = 0
    volume.data.render.precision = "FULL"
    material = bpy.data.materials.new("medium")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    output = nodes.new("ShaderNodeOutputMaterial")
    links.new(fill_material(nodes, links), output.inputs["Volume"])
    material.cycles.volume_sampling = "MULTIPLE_IMPORTANCE"
    volume.data.materials.append(material)
    return volume


def split_voxels(path, names, factor, out):
    """Cuts each voxel of float and vec3s grids into factor^3 of the same value. Cycles interpolates
    linearly; with ever smaller voxels that comes to values that are constant in the voxels of the
    file, as murk has them."""
    fine = []
    for name in names:
        source = pyopenvdb.read(path, name)
        low, high = source.evalActiveVoxelBoundingBox()
        vector = source.valueTypeName == "vec3s"
        size = [b - a + 1 for a, b in zip(low, high)]
        values = numpy.zeros(size + [3] * vector, numpy.float32)
        source.copyToArray(values, ijk=low)
        for axis in range(3):
            values = values.repeat(factor, axis)
        grid = pyopenvdb.Vec3SGrid() if vector else pyopenvdb.FloatGrid()
        grid.copyFromArray(values, ijk=tuple(factor * a for a in low))
        grid.name = name
        grid.transform = pyopenvdb.createLinearTransform(source.transform.voxelSize()[0] / factor)
        fine.append(grid)
    pyopenvdb.write(out, grids=fine)


def add_attribute(nodes, name):
    attribute = nodes.new("ShaderNodeAttribute")
    attribute.attribute_name = name
    return attribute


def scale(nodes, links, value, factor):
    product = nodes.new("ShaderNodeMath")
    product.operation = "MULTIPLY"
    product.inputs[1].default_value = factor
    links.new(value, product.inputs[0])
    return product.outputs[0]


def add_shaders(nodes, links, first, second):
    both = nodes.new("ShaderNodeAddShader")
    links.new(first, both.inputs[0])
    links.new(second, both.inputs[1])
    return both.outputs[0]


def coefficient(nodes, links, kind, color, density, factor):
    """A shader that absorbs or scatters with factor x density [1/m]."""
    shader = nodes.new(kind)
    shader.inputs["Color"].default_value = (color, color, color, 1)
    links.new(scale(nodes, links, density, factor), shader.inputs["Density"])
    return shader.outputs[0]


def radiosity_material(grid, kappa):
    """Absorbs with kappa x density, and emits what murk solved: kappa x density x B / pi."""
    def fill(nodes, links):
        density = add_attribute(nodes, grid).outputs["Fac"]
        emission = nodes.new("ShaderNodeEmission")
        links.new(add_attribute(nodes, "radiosity").outputs["Color"], emission.inputs["Color"])
        links.new(scale(nodes, links, density, kappa / math.pi), emission.inputs["Strength"])
        absorption = coefficient(nodes, links, "ShaderNodeVolumeAbsorption", 0, density, kappa)
        return add_shaders(nodes, links, absorption, emission.outputs[0])
    return fill


def scattering_material(grid, kappa, albedo):
    """Scatters and absorbs as the medium does, for Cycles to find all the light by itself."""
    def fill(nodes, links):
        density = add_attribute(nodes, grid).outputs["Fac"]
        return add_shaders(
            nodes, links,
            coefficient(nodes, links, "ShaderNodeVolumeScatter", 1, density, albedo * kappa),
            coefficient(nodes, links, "ShaderNodeVolumeAbsorption", 0, density,
                        (1 - albedo) * kappa))
    return fill


def in_bands(description, light, quantity):
    """A number of the sun or the sky as red, green and blue."""
    bands = description.get("bands", [description] * 3)
    return [{**description.get(light, {}), **band.get(light, {})}.get(quantity, 0)
            for band in bands]


def add_light(scene, description):
    sun = bpy.data.lights.new("sun", "SUN")
    sun.energy, sun.angle = 1, 0
    sun.color = in_bands(description, "sun", "irradiance")
    place = bpy.data.objects.new("sun", sun)
    along = Vector(description["sun"]["direction"])
    place.rotation_euler = along.to_track_quat("-Z", "Y").to_euler()
    scene.collection.objects.link(place)
    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    sky = scene.world.node_tree.nodes["Background"]
    sky.inputs["Color"].default_value = (*in_bands(description, "sky", "radiance"), 1)
    sky.inputs["Strength"].default_value = 1


def add_camera(scene, description):
    given = description.get("camera", {})
    missing = [key for key in ("eye", "target", "fov", "size") if key not in given]
    if missing:
        sys.exit("the scene's camera has no " + ", ".join(missing))
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit, camera.angle = "VERTICAL", math.radians(given["fov"])
    place = bpy.data.objects.new("camera", camera)
    place.location = given["eye"]
    back = (Vector(given["eye"]) - Vector(given["target"])).normalized()
    up = given.get("up", (0, 1, 0) if description.get("up") == "y" else (0, 0, 1))
    right = Vector(up).cross(back).normalized()
    place.rotation_euler = Matrix((right, back.cross(right), back)).transposed().to_euler()
    scene.collection.objects.link(place)
    scene.camera = place
    scene.render.resolution_x, scene.render.resolution_y = given["size"]
    scene.render.resolution_percentage = 100


def empty_scene():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    set_cycles(scene)
    return scene


def render(scene, samples, seed, path):
    """Writes the picture; gives the seconds that it took."""
    scene.cycles.samples, scene.cycles.seed = samples, seed
    scene.render.filepath = os.path.abspath(path)
    start = time.perf_counter()
    bpy.ops.render.render(write_still=True)
    return time.perf_counter() - start
