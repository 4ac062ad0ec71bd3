#include <burin/deform/evaluate/supported_inputs.h>
#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace burin {
namespace {

constexpr std::array<std::string_view, 26> known_inputs = {"t",
                                                           "d",
                                                           "radius",
                                                           "stretch",
                                                           "footprint",
                                                           "position",
                                                           "normal",
                                                           "e1",
                                                           "mean curvature",
                                                           "laplacian",
                                                           "displacement",
                                                           "mask",
                                                           "colour",
                                                           "sheet",
                                                           "visit count",
                                                           "node id",
                                                           "symmetry",
                                                           "pressure",
                                                           "tilt",
                                                           "twist",
                                                           "speed",
                                                           "time",
                                                           "foot",
                                                           "fine position",
                                                           "fine normal",
                                                           "fine mean curvature"};

constexpr std::array<std::string_view, 3> known_outputs = {"displacement", "mask", "colour"};

std::string names(std::uint64_t bits, std::span<const std::string_view> known) {
  std::string list;
  for (std::size_t bit = 0; bit < 64; ++bit) {
    if (!(bits >> bit & 1)) continue;
    if (!list.empty()) list += ", ";
    list += bit < known.size() ? std::string(known[bit]) : fmt::format("number {}", bit);
  }
  return list;
}

}  // namespace

std::string input_names(std::uint64_t inputs) { return names(inputs, known_inputs); }

std::string output_names(std::uint64_t outputs) { return names(outputs, known_outputs); }

}  // namespace burin
