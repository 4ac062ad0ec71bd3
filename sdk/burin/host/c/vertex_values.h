#pragma once
#include <burin/host/c/burin.h>
#include <burin/host/c/object_space.h>
#include <burin/host/session.h>

#include <cstddef>

namespace burin::c {

/// The most floats that an attribute has at a vertex.
inline constexpr std::size_t most_floats = 4;

/// The current values of an attribute, by vertex of the surface.
struct VertexValues {
  const float* data;   ///< as the surface has them, floats next to each other
  std::size_t size;    ///< floats of a vertex
  std::size_t stride;  ///< floats from one vertex to the next; 0: all have the same values
  burin_attribute attribute;
  const ObjectSpace* object;  ///< of the caller; null: the surface's own space
  const Index* source;        ///< [vertex] its number in the original mesh

  /// Writes the values of a vertex as the caller has them: `size` floats.
  void copy(Index vertex, float* to) const;
};

/// Throws plugin::Error for an attribute that does not exist. Valid until the next call of the session.
/// `object` may be null.
VertexValues values_of(const Session& session, burin_attribute attribute, const ObjectSpace* object);

/// Writes values of a vertex as the target wants them.
void write_values(const float* values, std::size_t size, burin_number type, void* to);

/// Number k of a vertex, as a float.
float read_value(const void* values, burin_number type, std::size_t k);

}  // namespace burin::c
