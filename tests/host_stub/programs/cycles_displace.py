"""Displaces a mesh by the material displacement of Cycles, in the background.

usage: blender --background --factory-startup --python cycles_displace.py -- MESH.obj MAP.exr KIND OUT

MESH.obj: as textured_mesh.py has it. MAP.exr lies over the texture coordinates. KIND: NORMAL, heights along the
normal, or OBJECT or TANGENT, vectors in that space. OUT gets a line "x y z" for each vertex: where Cycles has it,
which its pass of positions tells when it is baked on the vertices.
"""

import os
import sys

import bpy

sys.path.append(os.path.dirname(__file__))
from textured_mesh import map_image, read_mesh


def displacing_material(map_file, kind):
    material = bpy.data.materials.new("displaced")
    material.use_nodes = True
    material.cycles.displacement_method = "DISPLACEMENT"
    nodes, links = material.node_tree.nodes, material.node_tree.links
    texture = nodes.new("ShaderNodeTexImage")
    texture.image = map_image(map_file)
    texture.extension = "EXTEND"
    displacement = nodes.new("ShaderNodeDisplacement" if kind == "NORMAL" else "ShaderNodeVectorDisplacement")
    if kind != "NORMAL":
        displacement.space = kind
    displacement.inputs["Midlevel"].default_value = 0
    displacement.inputs["Scale"].default_value = 1
    links.new(texture.outputs["Color"], displacement.inputs["Height" if kind == "NORMAL" else "Vector"])
    links.new(displacement.outputs[0], nodes["Material Output"].inputs["Displacement"])
    return material


def baked_positions(mesh, material):
    mesh.materials.append(material)
    for polygon in mesh.polygons:
        polygon.use_smooth = True
    thing = bpy.data.objects.new("base", mesh)
    scene = bpy.context.scene
    scene.collection.objects.link(thing)
    places = mesh.color_attributes.new("places", "FLOAT_COLOR", "POINT")
    mesh.attributes.active_color = places
    bpy.context.view_layer.objects.active = thing
    thing.select_set(True)
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 1
    scene.render.bake.target = "VERTEX_COLORS"
    bpy.ops.object.bake(type="POSITION")
    return [value.color[:3] for value in places.data]


mesh_file, map_file, kind, out = sys.argv[sys.argv.index("--") + 1 :]
bpy.ops.wm.read_factory_settings(use_empty=True)
with open(out, "w") as lines:
    for place in baked_positions(read_mesh(mesh_file), displacing_material(map_file, kind)):
        lines.write("%.9g %.9g %.9g\n" % tuple(place))
