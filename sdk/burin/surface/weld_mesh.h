#pragma once
#include <burin/surface/polygon_mesh.h>

#include <vector>

// The functions may be called on any thread, also on several at once.
namespace burin {

/// The distance between equal positions that rounding to six digits in a text file may cause: 4e-6 of the
/// greatest coordinate, object units.
double rounding_tolerance(const PolygonMesh& mesh);

/// Finds the vertices that become one when the surface is joined along edges whose ends are at most
/// `tolerance` apart; object units, >= 0. Only edges with a single face are joined, as programs leave them at
/// seams of texture coordinates or at every face. Edges are joined in pairs only, so that no edge gets a
/// third face and no vertex a second fan. If several edges coincide, edges in the same order in the file are
/// paired, as in the copies of a doubled mesh; if that is not possible, the pairs with the flattest angle.
/// Faces that lie on each other, folded or doubled, are not joined. The two ends of an edge of length 0 are
/// joined too, as at the pole of a sphere. No vertex is joined with one farther away than a quarter of its
/// shortest edge. Faces must refer to existing vertices. Returns for every vertex the index of the vertex
/// that it becomes, in order of first appearance; an empty list if no vertices are joined.
std::vector<Index> find_welds(const PolygonMesh& mesh, double tolerance);

/// Joins vertices; `vertex_of` is the result of find_welds(). A joined vertex has the position and paint of
/// its first one. Corners that repeat the previous one are removed, and so are faces left with fewer than
/// three corners.
PolygonMesh weld(PolygonMesh mesh, const std::vector<Index>& vertex_of);

}  // namespace burin
