#pragma once
#include <burin/base/vector.h>
#include <burin/surface/formats/ply_header.h>

#include <span>
#include <vector>

namespace burin {

/// The texture coordinates of a PLY file. They are properties of the vertices named s and t, u and v,
/// texture_u and texture_v, or texture_s and texture_t; or face lists with these names and a number per
/// corner; or face lists texcoord, with u and v of each corner in turn.
class PlyTexture {
 public:
  /// The meaning of a property.
  enum class Slot : unsigned char { none, u, v, both };

  /// The meaning of each property of an element.
  static std::vector<Slot> vertex_slots(const PlyElement& vertices);
  static std::vector<Slot> face_slots(const PlyElement& faces);

  /// Starts the vertices; `textured` is whether any of their properties is a texture coordinate.
  void begin_vertices(std::size_t count, bool textured);
  void take(Slot slot, std::size_t vertex, double value);

  /// take_of_face() stores a value of a face's lists, end_face() completes the face.
  void take_of_face(Slot slot, double value);
  void end_face(std::size_t corners);

  /// The texture coordinates by corner, for faces with these vertices; empty unless all corners have them.
  std::vector<Vec2f> of_corners(std::span<const Index> face_vertices) const;

  /// The number of vertices or corners with texture coordinates.
  std::size_t count() const { return vertices_.size() + corners_.size(); }

 private:
  std::vector<Vec2f> vertices_, corners_;
  std::vector<float> u_, v_, both_;  ///< lists of the face that is being read
};

}  // namespace burin
