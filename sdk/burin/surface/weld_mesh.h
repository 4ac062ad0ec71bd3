#pragma once
#include <burin/surface/polygon_mesh.h>

#include <vector>

namespace burin {

/// How far rounding, as of six decimals in a text, moves places apart: 4e-6 of the greatest coordinate.
double rounding_tolerance(const PolygonMesh& mesh);

/// Which vertices become one when the surface is joined along edges whose ends are no farther apart than
/// `tolerance`, object units, >= 0: those of one face each, as programs leave them at seams of texture
/// coordinates or at every corner. Two edges are joined, and with them their ends, never more, so that no
/// edge gets a third face and no vertex a second fan. Where several lie at one place, those come together
/// that the file holds in the same order, as the copies of a doubled mesh are, or else the straightest. Faces
/// that lie on each other, front to back or doubled, are not joined there. Ends of an edge of no length are
/// joined too, as at the pole of a sphere. No vertex is joined to one farther away than a quarter of its
/// shortest edge. Faces name vertices that are there. Gives for every vertex the number of the one that it
/// becomes, in order of first appearance, or nothing where none are joined.
std::vector<Index> find_welds(const PolygonMesh& mesh, double tolerance);

/// The mesh with one vertex for all that become one, at the place and with the paint of the first. Faces and
/// corners stay as they are, but for corners that repeat the one before and faces that keep fewer than three.
PolygonMesh weld(PolygonMesh mesh, const std::vector<Index>& vertex_of);

}  // namespace burin
