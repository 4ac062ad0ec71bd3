#pragma once
#include <burin/abi/stroke.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace burin {

/// An input that this host fills, or an output that it takes; a brush that declares others is refused.
struct Supported {
  std::uint64_t bit;
  std::string_view name;  ///< for people
  std::size_t columns;    ///< of floats, that its members in the ABI's struct look into
  std::size_t bytes;      ///< of these members
};

/// The input or output of these members of burin_batch or burin_outputs.
template <class Struct, class... Members>
constexpr Supported supported(std::uint64_t bit, std::string_view name, Members Struct::*...) {
  // All members but whole numbers are made of these, which are alike.
  static_assert(sizeof(burin_floats) == sizeof(burin_floats_out));
  const auto columns = [](std::size_t bytes, bool whole) { return whole ? 0 : bytes / sizeof(burin_floats); };
  return {bit, name, (columns(sizeof(Members), std::is_same_v<Members, burin_indices>) + ...),
          (sizeof(Members) + ...)};
}

/// In the order of their bits.
inline constexpr std::array all_inputs{
    supported(BURIN_INPUT_T, "t", &burin_batch::t),
    supported(BURIN_INPUT_D, "d", &burin_batch::d),
    supported(BURIN_INPUT_RADIUS, "radius", &burin_batch::radius),
    supported(BURIN_INPUT_STRETCH, "stretch", &burin_batch::stretch),
    supported(BURIN_INPUT_FOOTPRINT, "footprint", &burin_batch::footprint_t, &burin_batch::footprint_d),
    supported(BURIN_INPUT_POSITION, "position", &burin_batch::position),
    supported(BURIN_INPUT_NORMAL, "normal", &burin_batch::normal),
    supported(BURIN_INPUT_E1, "e1", &burin_batch::e1),
    supported(BURIN_INPUT_MEAN_CURVATURE, "mean curvature", &burin_batch::mean_curvature),
    supported(BURIN_INPUT_LAPLACIAN, "laplacian", &burin_batch::laplacian),
    supported(BURIN_INPUT_DISPLACEMENT, "displacement", &burin_batch::displacement),
    supported(BURIN_INPUT_MASK, "mask", &burin_batch::mask),
    supported(BURIN_INPUT_COLOUR, "colour", &burin_batch::colour),
    supported(BURIN_INPUT_SHEET, "sheet", &burin_batch::sheet),
    supported(BURIN_INPUT_VISIT_COUNT, "visit count", &burin_batch::visit_count),
    supported(BURIN_INPUT_NODE_ID, "node id", &burin_batch::node_id),
    supported(BURIN_INPUT_SYMMETRY, "symmetry", &burin_batch::symmetry),
    supported(BURIN_INPUT_PRESSURE, "pressure", &burin_batch::pressure),
    supported(BURIN_INPUT_TILT, "tilt", &burin_batch::tilt_x, &burin_batch::tilt_y),
    supported(BURIN_INPUT_TWIST, "twist", &burin_batch::twist),
    supported(BURIN_INPUT_SPEED, "speed", &burin_batch::speed),
    supported(BURIN_INPUT_TIME, "time", &burin_batch::time),
    supported(BURIN_INPUT_FOOT, "foot", &burin_batch::foot, &burin_batch::foot_normal),
    supported(BURIN_INPUT_FINE_POSITION, "fine position", &burin_batch::fine_position),
    supported(BURIN_INPUT_FINE_NORMAL, "fine normal", &burin_batch::fine_normal),
    supported(BURIN_INPUT_FINE_MEAN_CURVATURE, "fine mean curvature", &burin_batch::fine_mean_curvature),
    supported(BURIN_INPUT_END_DISTANCE, "end distance", &burin_batch::end_distance)};
inline constexpr std::array all_outputs{
    supported(BURIN_OUTPUT_DISPLACEMENT, "displacement", &burin_outputs::along, &burin_outputs::across,
              &burin_outputs::up),
    supported(BURIN_OUTPUT_MASK, "mask", &burin_outputs::mask),
    supported(BURIN_OUTPUT_COLOUR, "colour", &burin_outputs::colour)};

/// All of them together.
template <std::size_t count>
constexpr Supported sum(const std::array<Supported, count>& all) {
  Supported sum{};
  for (const Supported& one : all) {
    sum.bit |= one.bit;
    sum.columns += one.columns;
    sum.bytes += one.bytes;
  }
  return sum;
}

inline constexpr std::uint64_t supported_inputs = sum(all_inputs).bit;
inline constexpr std::uint64_t supported_outputs = sum(all_outputs).bit;

/// The names of inputs or outputs for messages: "laplacian, mask". An unknown bit is given by its number.
std::string input_names(std::uint64_t inputs);
std::string output_names(std::uint64_t outputs);

}  // namespace burin
