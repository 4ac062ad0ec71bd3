#!/usr/bin/env bash
# Blender 3.4.1 with numpy 1.24.2, both as Debian 12 packages them: File > Import > glTF 2.0 fails on every file with
# its settings as they are, since the shading "Use Normal Data" (import_shading="NORMALS") asks for `numpy.bool`, which
# numpy 1.24 has no more. With import_shading="SMOOTH" or "FLAT" the same file opens.
#
# Writes a glTF file of one triangle, opens it both ways and prints what it got. Exit code 0: as told above; 1: other.
set -euo pipefail
blender=3.4.1+dfsg-2+b1 numpy=1:1.24.2-1+deb12u1
installed=$(dpkg-query -W -f '${Version} ' blender python3-numpy 2>/dev/null || true)
if [ "$installed" != "$blender $numpy " ]; then
  apt-get install -q -y --no-install-recommends "blender=$blender" "python3-numpy=$numpy" >/dev/null
fi
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cat >"$work/open.py" <<'PY'
import json, sys
import bpy

path = sys.argv[-1]
places = "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"
json.dump({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
           "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
           "buffers": [{"byteLength": 36, "uri": places}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
           "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0],
                          "max": [1, 1, 0]}]}, open(path, "w"))

def outcome(**settings):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    try:
        bpy.ops.import_scene.gltf(filepath=path, **settings)
    except RuntimeError as error:
        return "numpy.bool" if "has no attribute 'bool'" in str(error) else str(error)
    return "opened"

plain, smooth = outcome(), outcome(import_shading="SMOOTH")
print("FINDING as it is: %s, smooth: %s" % (plain, smooth))
sys.exit(0 if (plain, smooth) == ("numpy.bool", "opened") else 1)
PY
dpkg-query -W blender python3-numpy
status=0
blender --background --factory-startup --python-exit-code 3 --python "$work/open.py" -- "$work/a.gltf" >"$work/log" 2>&1 || status=$?
sed -n 's/^FINDING //p' "$work/log"
exit "$status"
