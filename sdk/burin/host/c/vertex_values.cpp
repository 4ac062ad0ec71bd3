#include <burin/host/c/call.h>
#include <burin/host/c/vertex_values.h>

#include <cstring>

namespace burin::c {
namespace {

constexpr float bare_colour[] = {1, 1, 1, 0};
constexpr float bare_mask = 1;

}  // namespace

VertexValues values_of(const Session& session, burin_attribute attribute) {
  const Paint& paint = session.paint();
  switch (attribute) {
    case BURIN_POSITIONS:
      return {session.positions().front().data(), 3, 3};
    case BURIN_NORMALS:
      return {session.normals().front().data(), 3, 3};
    case BURIN_COLOURS:
      if (paint.colour.empty()) return {bare_colour, 4, 0};
      return {paint.colour.front().data(), 4, 4};
    case BURIN_MASKS:
      if (paint.mask.empty()) return {&bare_mask, 1, 0};
      return {paint.mask.data(), 1, 1};
    default:
      reject("there is no such attribute");
  }
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
