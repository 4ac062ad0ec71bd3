"""A Blender mesh of triangles as a binary PLY file, in Blender's order."""

import array

HEADER = """ply
format binary_little_endian 1.0
element vertex {}
property float x
property float y
property float z
element face {}
property list uchar int vertex_indices
end_header
"""


def positions(mesh):
    """x0 y0 z0 x1 ..., as they are now."""
    values = array.array("f", bytes(12 * len(mesh.vertices)))
    mesh.vertices.foreach_get("co", values)
    return values


def face_records(mesh):
    """A byte 3 and three 32-bit indices for each triangle."""
    corners = array.array("i", bytes(4 * len(mesh.loops)))
    mesh.loops.foreach_get("vertex_index", corners)
    indices = corners.tobytes()
    records = bytearray(b"\3" * (13 * len(mesh.polygons)))
    for byte in range(12):
        records[1 + byte :: 13] = indices[byte::12]
    return records


def write_ply(path, mesh):
    with open(path, "wb") as file:
        file.write(HEADER.format(len(mesh.vertices), len(mesh.polygons)).encode("ascii"))
        file.write(positions(mesh).tobytes())
        file.write(face_records(mesh))
