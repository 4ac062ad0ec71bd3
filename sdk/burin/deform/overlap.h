#pragma once
#include <array>
#include <cstdint>
#include <string_view>

struct burin_brush_descriptor;

namespace burin {

/// What a vertex does where a stroke overlaps itself and each of its sheets would displace or tint it: the
/// sheets of a chart that the stroke visits several times, of its dabs, of its symmetric images and of its
/// pieces. docs/overlap.md tells more. All but `latest` give the same whichever way the stroke runs.
enum class Overlap {
  latest,     ///< as the sheet drawn last says, which lies on top of those before
  max,        ///< as the sheet that moves it farthest outward along the vertex normal; the most of a tint
  min,        ///< as the sheet that moves it farthest inward; the least
  add,        ///< the sum of all sheets; of images and of several passes, which never add up, the strongest
  average,    ///< their mean
  strongest,  ///< the highest rise and the deepest cut together; of a tint the greatest changes
};

struct OverlapName {
  std::string_view name;
  Overlap overlap;
};

/// All of them by what people call them.
inline constexpr std::array<OverlapName, 6> named_overlaps{{{"strongest", Overlap::strongest},
                                                            {"latest", Overlap::latest},
                                                            {"max", Overlap::max},
                                                            {"min", Overlap::min},
                                                            {"add", Overlap::add},
                                                            {"average", Overlap::average}}};

std::string_view name_of(Overlap overlap);

/// What a stroke of so many passes makes of the chosen way. Each pass goes on from the one before: sums over
/// many sheets would overshoot, the more from pass to pass, and the strongest holds instead.
Overlap over_passes(Overlap chosen, std::uint32_t passes);

/// What the brush says of itself.
Overlap overlap_of(const burin_brush_descriptor& brush);

}  // namespace burin
