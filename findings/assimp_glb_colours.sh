#!/usr/bin/env bash
# assimp 5.2.5 (Debian 12), two surprises with colours of vertices:
#
# 1. COLOR_0 of three numbers in glTF, which glTF allows and which means opaque, is imported with an alpha of 0, so
#    that what honours alpha shows nothing. With four numbers, the fourth 1, all is well.
# 2. A binary PLY file that it exports ("assimp export a.glb a.ply -fplyb") says `property uchar red` and so on, but
#    holds floats: it is 12 bytes a vertex longer than its header says, and no reader finds the places in it.
#
# Writes a GLB file of one triangle, exports it as text and as binary PLY, and prints what it got. Exit code 0: as told
# above; 1: other.
set -euo pipefail
version=5.2.5~ds0-1+b1
if [ "$(dpkg-query -W -f '${Version}' assimp-utils 2>/dev/null)" != "$version" ]; then
  apt-get install -q -y --no-install-recommends "assimp-utils=$version" python3 >/dev/null
fi
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cd "$work"
cat >glb.py <<'PY'
import json, struct, sys

def glb(path, channels):
    colour = {3: "<3f", 4: "<4f"}[channels]
    places = b"".join(struct.pack("<3f", *p) for p in [(0, 0, 0), (1, 0, 0), (0, 1, 0)])
    colours = struct.pack(colour, *[1, 0.5, 0.25, 1][:channels]) * 3
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "COLOR_0": 1}}]}],
        "buffers": [{"byteLength": len(places + colours)}],
        "bufferViews": [{"buffer": 0, "byteLength": len(places)},
                        {"buffer": 0, "byteOffset": len(places), "byteLength": len(colours)}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                       "min": [0, 0, 0], "max": [1, 1, 0]},
                      {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC%d" % channels}]}
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    data = places + colours
    with open(path, "wb") as out:
        out.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data)))
        out.write(struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data)

def alpha(path):
    body = open(path).read().split("end_header\n")[1]
    return body.split("\n")[0].split()[6]

def excess(path):
    """Bytes beyond what the header tells, per vertex."""
    header, body = open(path, "rb").read().split(b"end_header\n", 1)
    assert b"property uchar red" in header and b"element vertex 3" in header and b"element face 1" in header
    return (len(body) - 3 * (12 + 4) - (1 + 3 * 4)) / 3

if sys.argv[1] == "write":
    glb("three.glb", 3)
    glb("four.glb", 4)
else:
    three, four, more = alpha("three.ply"), alpha("four.ply"), excess("binary.ply")
    print("alpha of three numbers:", three, "of four:", four, "| bytes too many a vertex in binary PLY:", more)
    sys.exit(0 if (three, four, more) == ("0", "255", 12) else 1)
PY
python3 glb.py write
assimp export three.glb three.ply -fply >/dev/null
assimp export four.glb four.ply -fply >/dev/null
assimp export four.glb binary.ply -fplyb >/dev/null
dpkg-query -W assimp-utils
python3 glb.py check
