#!/usr/bin/env bash
# Blender 3.4.1 (Debian 12): File > Export > Wavefront (.obj) with "Triangulated Mesh" leaves one triangle out of
# Blender's own monkey, and so tears a hole and leaves an edge with three faces. In the monkey, as in many meshes of
# quads, two quads meet along two edges, with a vertex between that has no others. Both are cut along the diagonal
# that leads past that vertex, which gives the same triangle twice, and the second one is dropped without a word.
# "Wavefront (.obj) (legacy)", and the triangles by which Blender itself draws the mesh, have all 968 triangles.
#
# Exports the monkey by both, counts triangles, edges of one face and edges of three, and prints what it got. Exit code 0:
# as told above; 1: other.
set -euo pipefail
version=3.4.1+dfsg-2+b1
if [ "$(dpkg-query -W -f '${Version}' blender 2>/dev/null)" != "$version" ]; then
  apt-get install -q -y --no-install-recommends "blender=$version" >/dev/null
fi
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cat >"$work/export.py" <<'PY'
import collections, sys
import bpy

folder = sys.argv[-1]

def edges_by_faces(faces):
    """The numbers of edges of one face, and of three or more."""
    edges = collections.Counter(tuple(sorted((face[i - 1], face[i]))) for face in faces for i in range(len(face)))
    return sum(n == 1 for n in edges.values()), sum(n > 2 for n in edges.values())

def counts(path):
    faces = [[word.split("/")[0] for word in line.split()[1:]] for line in open(path) if line.startswith("f ")]
    return (len(faces), *edges_by_faces(faces))

bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.mesh.primitive_monkey_add()
mesh = bpy.context.object.data
mesh.calc_loop_triangles()
drawn = (len(mesh.loop_triangles), *edges_by_faces([list(face.vertices) for face in mesh.polygons]))
bpy.ops.wm.obj_export(filepath=folder + "/new.obj", export_triangulated_mesh=True)
bpy.ops.export_scene.obj(filepath=folder + "/legacy.obj", use_triangles=True)
new, legacy = counts(folder + "/new.obj"), counts(folder + "/legacy.obj")
print("Blender", bpy.app.version_string, "- triangles, edges of one face, edges of three:")
print("found: in the mesh", drawn, "| legacy exporter", legacy, "| exporter", new)
sys.exit(0 if (drawn, legacy, new) == ((968, 42, 0), (968, 42, 1), (967, 44, 1)) else 1)
PY
blender --background --factory-startup --python-exit-code 1 --python "$work/export.py" -- "$work" | grep -E '^(Blender .* - |found:)'
