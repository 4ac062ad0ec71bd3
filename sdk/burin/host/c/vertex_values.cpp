#include <burin/host/c/call.h>
#include <burin/host/c/vertex_values.h>

#include <algorithm>
#include <cstring>

namespace burin::c {
namespace {

constexpr float bare_colour[] = {1, 1, 1, 0};
constexpr float bare_mask = 1;

}  // namespace

VertexValues values_of(const Session& session, burin_attribute attribute, const ObjectSpace* object) {
  const Paint& paint = session.paint();
  const auto values = [&](const float* data, std::size_t size, std::size_t stride) -> VertexValues {
    return {data, size, stride, attribute, object, session.surface().source_vertex.data()};
  };
  switch (attribute) {
    case BURIN_POSITIONS:
      return values(session.positions().front().data(), 3, 3);
    case BURIN_NORMALS:
      return values(session.normals().front().data(), 3, 3);
    case BURIN_COLOURS:
      if (paint.colour.empty()) return values(bare_colour, 4, 0);
      return values(paint.colour.front().data(), 4, 4);
    case BURIN_MASKS:
      if (paint.mask.empty()) return values(&bare_mask, 1, 0);
      return values(paint.mask.data(), 1, 1);
    default:
      reject("there is no such attribute");
  }
}

void VertexValues::copy(Index vertex, float* to) const {
  const float* const from = data + vertex * stride;
  const bool placed = object && (attribute == BURIN_POSITIONS || attribute == BURIN_NORMALS);
  if (!placed) {
    std::copy_n(from, size, to);
    return;
  }
  const Vec3f world(from[0], from[1], from[2]);
  const Vec3f given =
      attribute == BURIN_POSITIONS ? object->position(source[vertex], world) : object->normal(world);
  std::copy_n(given.data(), size, to);
}

void write_values(const float* values, std::size_t size, burin_number type, void* to) {
  if (type == BURIN_FLOAT32) {
    std::memcpy(to, values, size * sizeof(float));
    return;
  }
  for (std::size_t i = 0; i < size; ++i) {
    const double value{values[i]};
    std::memcpy(static_cast<char*>(to) + i * sizeof value, &value, sizeof value);
  }
}

float read_value(const void* values, burin_number type, std::size_t k) {
  const char* const data = static_cast<const char*>(values);
  if (type == BURIN_FLOAT32) {
    float value = 0;
    std::memcpy(&value, data + k * sizeof value, sizeof value);
    return value;
  }
  double value = 0;
  std::memcpy(&value, data + k * sizeof value, sizeof value);
  return static_cast<float>(value);
}

}  // namespace burin::c
