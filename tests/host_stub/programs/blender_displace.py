"""Displaces a mesh by Blender's Displace modifier, in the background.

usage: blender --background --factory-startup --python blender_displace.py -- MESH.obj MAP.exr DIRECTION OUT

MESH.obj: vertices "v", texture coordinates "vt" one for each vertex, triangles "f a/a b/b c/c". MAP.exr lies
over the texture coordinates. DIRECTION: NORMAL or RGB_TO_XYZ. OUT gets a line "x y z" for each vertex.
"""

import sys

import bpy


def read_mesh(path):
    points, uv, faces = [], [], []
    for line in open(path):
        words = line.split()
        if words[:1] == ["v"]:
            points.append([float(word) for word in words[1:4]])
        elif words[:1] == ["vt"]:
            uv.append([float(word) for word in words[1:3]])
        elif words[:1] == ["f"]:
            faces.append([int(word.split("/")[0]) - 1 for word in words[1:]])
    mesh = bpy.data.meshes.new("base")
    mesh.from_pydata(points, [], faces)
    layer = mesh.uv_layers.new()
    for loop in mesh.loops:
        layer.data[loop.index].uv = uv[loop.vertex_index]
    return mesh


def displaced(mesh, map_file, direction):
    image = bpy.data.images.load(map_file)
    image.colorspace_settings.name = "Non-Color"
    texture = bpy.data.textures.new("map", "IMAGE")
    texture.image = image
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
