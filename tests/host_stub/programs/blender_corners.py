"""Opens a mesh by Blender and writes what it sees.

usage: blender --background --factory-startup --python blender_corners.py -- FILE OUT

OUT gets a line "x y z r g b" for each corner of each face: its place in Blender's world, where z is up, and its
colour in linear light.
"""

import sys

import bpy


def load(path):
    if path.endswith(".ply"):
        bpy.ops.import_mesh.ply(filepath=path)
    elif path.endswith(".obj"):
        bpy.ops.wm.obj_import(filepath=path)
    else:
        # Not the shading by the file's normals, which numpy 1.24, as Debian has it, does not let through.
        bpy.ops.import_scene.gltf(filepath=path, import_shading="SMOOTH")


file, out = sys.argv[sys.argv.index("--") + 1 :]
bpy.ops.wm.read_factory_settings(use_empty=True)
load(file)
with open(out, "w") as lines:
    for thing in bpy.context.scene.objects:
        if thing.type != "MESH":
            continue
        mesh = thing.data
        colours = mesh.color_attributes[0]
        for loop in mesh.loops:
            place = thing.matrix_world @ mesh.vertices[loop.vertex_index].co
            at = loop.vertex_index if colours.domain == "POINT" else loop.index
            lines.write("%.9g %.9g %.9g %.9g %.9g %.9g\n" % (*place, *colours.data[at].color[:3]))
