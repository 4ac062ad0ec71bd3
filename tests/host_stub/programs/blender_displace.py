"""Displaces a mesh by Blender's Displace modifier, in the background.

usage: blender --background --factory-startup --python blender_displace.py -- MESH.obj MAP.exr DIRECTION OUT

MESH.obj: as textured_mesh.py has it. MAP.exr lies over the texture coordinates. DIRECTION: NORMAL or RGB_TO_XYZ.
OUT gets a line "x y z" for each vertex.
"""

import os
import sys

import bpy

sys.path.append(os.path.dirname(__file__))
from textured_mesh import map_image, read_mesh


def displaced(mesh, map_file, direction):
    texture = bpy.data.textures.new("map", "IMAGE")
    texture.image = map_image(map_file)
    texture.extension = "EXTEND"
    texture.use_clamp = False  # else negative values are cut off
    thing = bpy.data.objects.new("base", mesh)
    bpy.context.scene.collection.objects.link(thing)
    modifier = thing.modifiers.new("displace", "DISPLACE")
    modifier.texture = texture
    modifier.texture_coords = "UV"
    modifier.uv_layer = mesh.uv_layers[0].name
    modifier.direction = direction
    modifier.mid_level = 0
    modifier.strength = 1
    return thing.evaluated_get(bpy.context.evaluated_depsgraph_get()).data.vertices


mesh_file, map_file, direction, out = sys.argv[sys.argv.index("--") + 1 :]
with open(out, "w") as lines:
    for vertex in displaced(read_mesh(mesh_file), map_file, direction):
        lines.write("%.9g %.9g %.9g\n" % tuple(vertex.co))
