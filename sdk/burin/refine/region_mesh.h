#pragma once
#include <burin/refine/given_shape.h>
#include <burin/surface/surface.h>
#include <burin/surface/topology/vertex_star.h>

#include <array>
#include <cstddef>
#include <span>
#include <unordered_map>
#include <vector>

namespace burin {

/// A side of a face: 3 * face + i runs from its corner i to the next.
using Side = Index;

struct VertexFan;

/// The triangles of a surface that are being changed, as faces. Faces are taken in when they are first
/// needed, so that all costs depend on what is changed. Any number of faces may meet at an edge: the sides of
/// an edge form a ring, on a border of one side.
class RegionMesh {
 public:
  /// `given`: [vertex] where vertices of the surface were before it was drawn on. Both must outlive the
  /// object.
  RegionMesh(const Surface& surface, std::span<const Vec3f> given) : surface_(&surface), given_(given) {}

  struct Face {
    Triangle corners{};           ///< vertices of the mesh
    std::array<Side, 3> next{};   ///< [side] the next of the ring; no_index where it is not known yet
    std::array<bool, 3> sharp{};  ///< [side] once the ring is known: see is_sharp()
    TriangleUv uv{};              ///< if the surface has them
    Index origin = no_index;      ///< a triangle of the surface that it came of, or is near to
    bool changed = false;         ///< it is not that triangle any more
    bool gone = false;            ///< it is no face any more
  };

  struct Vertex {
    Vec3d at, given;          ///< where it is and would be if nothing was drawn; object units, as floats
    Index source = no_index;  ///< its number in the surface
    bool is_crowded = false;  ///< its faces may form several fans, or more than two meet at its edges
  };

  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<Vertex>& vertices() const { return vertices_; }

  /// The face of a triangle of the surface.
  Index take_in(Index triangle);

  /// Makes all rings of a face known.
  void connect(Index face);

  Index from(Side side) const { return faces_[side / 3].corners[side % 3]; }
  Index to(Side side) const { return from(after(side)); }
  Index apex(Side side) const { return from(before(side)); }
  static Side after(Side side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static Side before(Side side) { return side % 3 == 0 ? side + 2 : side - 1; }
  Side next(Side side) const { return faces_[side / 3].next[side % 3]; }
  bool is_sharp_side(Side side) const { return faces_[side / 3].sharp[side % 3]; }
  double squared_length(Side side) const { return (position(to(side)) - position(from(side))).squaredNorm(); }
  double judged_squared_length(Side side) const {
    const Vertex &a = vertices_[from(side)], &b = vertices_[to(side)];
    return judged_squared(a.at, b.at, a.given, b.given);
  }
  const Vec3d& position(Index vertex) const { return vertices_[vertex].at; }

  /// The other side of an edge of two; no_index for other edges.
  Side twin(Side side) const {
    const Side other = next(side);
    return other != side && next(other) == side ? other : no_index;
  }

  /// The triangles of the surface that are not faces any more, ascending.
  std::vector<Index> changed_triangles() const;

  /// Splits an edge at a new vertex, the last one; `opposite` gets the sides of the faces
  /// around it that do not touch it. All faces at the edge must be connected.
  void split(Side side, const Vec3d& at, std::vector<Side>& opposite);

  /// The corners of a face, with texture coordinates if the surface has them.
  struct Corners {
    Triangle vertices;
    TriangleUv uv;
  };

  /// The two faces at a side and at its twin once flip() has turned their edge.
  std::array<Corners, 2> flipped(Side side) const;

  /// Turns the edge between two faces, so that it joins their apexes; `outer` gets the four sides around. The
  /// faces must be connected and agree on outside, and the apexes may not be joined already.
  void flip(Side side, std::array<Side, 4>& outer);

  /// Where the edge from a vertex to its neighbour is collapsed.
  struct Collapse {
    std::size_t onto;   ///< number of the neighbour
    std::size_t crest;  ///< number of the other neighbour along a sharp line, or the same if there is none
  };

  /// Moves a vertex onto a neighbour: the faces between them are gone, those on either side of the sharp line
  /// take the neighbour's place and texture coordinates on that side. The edge must satisfy the link
  /// condition.
  void collapse(const VertexFan& fan, const Collapse& how);

  /// Whether an edge joins the vertex at which a side begins, which is not crowded, with another one.
  bool are_joined(Side side, Index other);

 private:
  void connect_side(Side side);
  Index vertex_of(Index source);
  Vec3d given_between(Index a, Index b, const Vec3d& at) const;
  bool is_crowded(Index source);
  void link(Side side, Side next) { faces_[side / 3].next[side % 3] = next; }
  Side previous(Side side) const;
  bool is_beside(Side side, Index other, bool forwards, bool& whole);
  void close_ring(const std::vector<Side>& ring);
  void close_over(Side outer, Side inner);

  const Surface* surface_;
  std::span<const Vec3f> given_;
  std::vector<Face> faces_;
  std::vector<Vertex> vertices_;
  std::unordered_map<Index, Index> face_of_, vertex_of_;  ///< by number in the surface
  VertexStar star_;
  std::vector<Index> beside_;
  std::vector<Side> ring_, first_half_, second_half_;
};

}  // namespace burin
