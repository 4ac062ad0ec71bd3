#pragma once
#include <burin/remesh/patch_mesh.h>

namespace burin {

/// Splits triangles along the line on which `field` is 0; new vertices are brought to the surface. Returns
/// the field at the vertices, 0 at new ones.
std::vector<double> cut(PatchMesh& patch, const PointField& field, const BringPoint& bring);

/// The same, and leaves only the part in which the field is above 0.
void clip(PatchMesh& patch, const PointField& field, const BringPoint& bring);

}  // namespace burin
