#pragma once
#include <burin/remesh/patch_mesh.h>

namespace burin {

/// Splits triangles along the line on which `field` is 0; new vertices are brought to the surface. Returns
/// the field at the vertices, 0 at new ones.
std::vector<double> cut(PatchMesh& patch, const PointField& field, const BringPoint& bring);

/// A patch whose triangles lie on either side of a line.
struct DividedPatch {
  PatchMesh patch;
  std::vector<double> field;  ///< [vertex] 0 on the line
  std::vector<char> kept;     ///< [triangle] whether it belongs to the part that stays
};

/// A patch divided where `field` is 0. The part in which it is above 0 is kept.
DividedPatch divide(PatchMesh patch, const PointField& field, const BringPoint& bring);

std::vector<Triangle> kept_triangles(const DividedPatch& divided);

/// The kept triangles by themselves, with the vertices that they have.
PatchMesh kept_part(const DividedPatch& divided);

}  // namespace burin
