#pragma once
#include <burin/abi/stroke.h>

#include <array>
#include <cstddef>

namespace burin_probe {

inline float at(const burin_floats& array, std::uint32_t i) {
  return array.data[std::size_t{i} * array.stride];
}
inline std::uint32_t at(const burin_indices& array, std::uint32_t i) {
  return array.data[std::size_t{i} * array.stride];
}
inline float& at(const burin_floats_out& array, std::uint32_t i) {
  return array.data[std::size_t{i} * array.stride];
}

/// One array of a batch.
struct Array {
  std::uint64_t input;  ///< BURIN_INPUT_*
  const char* name;
  const void* data;
  std::uint32_t stride;  ///< elements
  bool whole;            ///< holds unsigned integers, not floats
};

/// All arrays of a batch.
inline auto arrays_of(const burin_batch& batch) {
  const auto floats = [](std::uint64_t input, const char* name, const burin_floats& array) {
    return Array{input, name, array.data, array.stride, false};
  };
  const auto indices = [](std::uint64_t input, const char* name, const burin_indices& array) {
    return Array{input, name, array.data, array.stride, true};
  };
  const burin_batch& b = batch;
  return std::array{floats(BURIN_INPUT_T, "t", b.t),
                    floats(BURIN_INPUT_D, "d", b.d),
                    floats(BURIN_INPUT_RADIUS, "radius", b.radius),
                    floats(BURIN_INPUT_STRETCH, "stretch", b.stretch),
                    floats(BURIN_INPUT_FOOTPRINT, "footprint_t", b.footprint_t),
                    floats(BURIN_INPUT_FOOTPRINT, "footprint_d", b.footprint_d),
                    floats(BURIN_INPUT_POSITION, "position.x", b.position.x),
                    floats(BURIN_INPUT_POSITION, "position.y", b.position.y),
                    floats(BURIN_INPUT_POSITION, "position.z", b.position.z),
                    floats(BURIN_INPUT_NORMAL, "normal.x", b.normal.x),
                    floats(BURIN_INPUT_NORMAL, "normal.y", b.normal.y),
                    floats(BURIN_INPUT_NORMAL, "normal.z", b.normal.z),
                    floats(BURIN_INPUT_E1, "e1.x", b.e1.x),
                    floats(BURIN_INPUT_E1, "e1.y", b.e1.y),
                    floats(BURIN_INPUT_E1, "e1.z", b.e1.z),
                    floats(BURIN_INPUT_MEAN_CURVATURE, "mean_curvature", b.mean_curvature),
                    floats(BURIN_INPUT_LAPLACIAN, "laplacian.x", b.laplacian.x),
                    floats(BURIN_INPUT_LAPLACIAN, "laplacian.y", b.laplacian.y),
                    floats(BURIN_INPUT_LAPLACIAN, "laplacian.z", b.laplacian.z),
                    floats(BURIN_INPUT_DISPLACEMENT, "displacement.x", b.displacement.x),
                    floats(BURIN_INPUT_DISPLACEMENT, "displacement.y", b.displacement.y),
                    floats(BURIN_INPUT_DISPLACEMENT, "displacement.z", b.displacement.z),
                    floats(BURIN_INPUT_MASK, "mask", b.mask),
                    floats(BURIN_INPUT_COLOUR, "colour.r", b.colour.r),
                    floats(BURIN_INPUT_COLOUR, "colour.g", b.colour.g),
                    floats(BURIN_INPUT_COLOUR, "colour.b", b.colour.b),
                    floats(BURIN_INPUT_COLOUR, "colour.a", b.colour.a),
                    indices(BURIN_INPUT_SHEET, "sheet", b.sheet),
                    indices(BURIN_INPUT_VISIT_COUNT, "visit_count", b.visit_count),
                    indices(BURIN_INPUT_NODE_ID, "node_id", b.node_id),
                    indices(BURIN_INPUT_SYMMETRY, "symmetry", b.symmetry),
                    floats(BURIN_INPUT_PRESSURE, "pressure", b.pressure),
                    floats(BURIN_INPUT_TILT, "tilt_x", b.tilt_x),
                    floats(BURIN_INPUT_TILT, "tilt_y", b.tilt_y),
                    floats(BURIN_INPUT_TWIST, "twist", b.twist),
                    floats(BURIN_INPUT_SPEED, "speed", b.speed),
                    floats(BURIN_INPUT_TIME, "time", b.time),
                    floats(BURIN_INPUT_FOOT, "foot.x", b.foot.x),
                    floats(BURIN_INPUT_FOOT, "foot.y", b.foot.y),
                    floats(BURIN_INPUT_FOOT, "foot.z", b.foot.z),
                    floats(BURIN_INPUT_FOOT, "foot_normal.x", b.foot_normal.x),
                    floats(BURIN_INPUT_FOOT, "foot_normal.y", b.foot_normal.y),
                    floats(BURIN_INPUT_FOOT, "foot_normal.z", b.foot_normal.z),
                    floats(BURIN_INPUT_FINE_POSITION, "fine_position.x", b.fine_position.x),
                    floats(BURIN_INPUT_FINE_POSITION, "fine_position.y", b.fine_position.y),
                    floats(BURIN_INPUT_FINE_POSITION, "fine_position.z", b.fine_position.z),
                    floats(BURIN_INPUT_FINE_NORMAL, "fine_normal.x", b.fine_normal.x),
                    floats(BURIN_INPUT_FINE_NORMAL, "fine_normal.y", b.fine_normal.y),
                    floats(BURIN_INPUT_FINE_NORMAL, "fine_normal.z", b.fine_normal.z),
                    floats(BURIN_INPUT_FINE_MEAN_CURVATURE, "fine_mean_curvature", b.fine_mean_curvature),
                    floats(BURIN_INPUT_END_DISTANCE, "end_distance", b.end_distance)};
}

}  // namespace burin_probe
