#pragma once
#include <burin/surface/polygon_mesh.h>

#include <vector>

namespace burin {

/// A mesh whose surface hangs together where that of its file only touches.
struct WeldedMesh {
  /// One vertex for all that are joined, at the place and with the paint of the first, in order of first
  /// appearance. Faces and corners are those of the file, but for corners that repeat the one before.
  PolygonMesh mesh;
  std::vector<Index> vertex_of;  ///< [vertex of the file] its vertex in `mesh`; empty where none are joined
};

/// How far rounding, as of six decimals in a text, moves places apart: 4e-6 of the greatest coordinate.
double rounding_tolerance(const PolygonMesh& mesh);

/// Joins the surface along edges whose ends are no farther apart than `tolerance`, object units, >= 0: those
/// of one face each, as programs leave them at seams of texture coordinates or at every corner. Two edges
/// are joined, and with them their ends, never more, so that no edge gets a third face and no vertex a second
/// fan. Where several lie at one place, those come together that the file holds in the same order, as the
/// copies of a doubled mesh are, or else the straightest. Faces that lie on each other, front to back or
/// doubled, are not joined there. Ends of an edge of no length are joined too, as at the pole of a sphere.
/// No vertex is joined to one farther away than a quarter of its shortest edge. Faces name vertices that are
/// there.
WeldedMesh weld_mesh(PolygonMesh mesh, double tolerance);

}  // namespace burin
