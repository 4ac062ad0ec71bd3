#pragma once
#include <burin/base/vector.h>
#include <burin/surface/formats/ply_header.h>

#include <span>
#include <vector>

namespace burin {

/// The texture coordinates of a PLY file: properties of the vertices, s and t, u and v, texture_u and
/// texture_v or texture_s and texture_t, or lists of the faces: of these names, with a number a corner, or
/// texcoord, with u and v of one corner after the other.
class PlyTexture {
 public:
  /// What a property gives; its number among those of its element finds it.
  enum class Slot : unsigned char { none, u, v, both };

  /// Of each property of an element.
  static std::vector<Slot> vertex_slots(const PlyElement& vertices);
  static std::vector<Slot> face_slots(const PlyElement& faces);

  void begin_vertices(std::size_t count, bool textured);
  void take(Slot slot, std::size_t vertex, double value);

  /// Between these, the values of a face's lists.
  void take_of_face(Slot slot, double value);
  void end_face(std::size_t corners);

  /// [corner], of faces with these vertices; empty unless all have them.
  std::vector<Vec2f> of_corners(std::span<const Index> face_vertices) const;

  /// How many vertices or corners have texture coordinates.
  std::size_t count() const { return vertices_.size() + corners_.size(); }

 private:
  std::vector<Vec2f> vertices_, corners_;
  std::vector<float> u_, v_, both_;  ///< of the face that is being read
};

}  // namespace burin
