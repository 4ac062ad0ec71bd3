"""Meshes and displacement maps for the tests with Blender, whose own reader would turn and join."""

import bpy


def read_mesh(path):
    """Of an OBJ file: vertices "v", texture coordinates "vt" one for each vertex, triangles "f a/a b/b c/c"."""
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


def map_image(path):
    image = bpy.data.images.load(path)
    image.colorspace_settings.name = "Non-Color"
    return image
