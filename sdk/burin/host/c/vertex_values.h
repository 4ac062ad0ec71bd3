#pragma once
#include <burin/host/c/burin.h>
#include <burin/host/session.h>

#include <cstddef>

namespace burin::c {

/// The current values of an attribute by vertex of the surface, floats next to each other.
struct VertexValues {
  const float* data;
  std::size_t size;    ///< floats of a vertex
  std::size_t stride;  ///< floats from one vertex to the next; 0: all have the same values

  const float* of(Index vertex) const { return data + vertex * stride; }
};

/// Throws plugin::Error for an attribute that does not exist. Valid until the next call of the session.
VertexValues values_of(const Session& session, burin_attribute attribute);

/// Writes values of a vertex as the target wants them.
void write_values(const float* values, std::size_t size, burin_number type, void* to);

/// Number k of a vertex, as a float.
float read_value(const void* values, burin_number type, std::size_t k);

}  // namespace burin::c
