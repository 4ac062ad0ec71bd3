#pragma once
#include <array>
#include <cstdint>
#include <string_view>

struct burin_brush_descriptor;

namespace burin {

/// How the sheets of a vertex are combined where a stroke overlaps itself. A vertex has a sheet for each
/// visit of the stroke, for each dab, symmetric image and piece that reaches it. See docs/overlap.md. All
/// rules but `latest` give the same result in whichever direction the stroke runs.
enum class Overlap {
  latest,   ///< the sheet that was drawn last lies on top of earlier ones
  max,      ///< the sheet that moves the vertex farthest outward along its normal; the greatest tint channels
  min,      ///< the sheet that moves the vertex farthest inward; the least tint channels
  add,      ///< the sum of all sheets; images and multi-pass brushes use `strongest` instead of a sum
  average,  ///< the weighted mean of all sheets
  strongest,  ///< the sum of the highest rise and the deepest cut; for tints, of the greatest changes
};

struct OverlapName {
  std::string_view name;
  Overlap overlap;
};

/// The rules with the names that users see.
inline constexpr std::array<OverlapName, 6> named_overlaps{{{"strongest", Overlap::strongest},
                                                            {"latest", Overlap::latest},
                                                            {"max", Overlap::max},
                                                            {"min", Overlap::min},
                                                            {"add", Overlap::add},
                                                            {"average", Overlap::average}}};

std::string_view name_of(Overlap overlap);

/// The rule to use for a brush with this many passes. Each pass starts from the result of the previous one,
/// so sums over many sheets would overshoot more with each pass; `strongest` is used instead of `add`.
Overlap over_passes(Overlap chosen, std::uint32_t passes);

/// The rule that a brush declares.
Overlap overlap_of(const burin_brush_descriptor& brush);

}  // namespace burin
