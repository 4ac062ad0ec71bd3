#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

// The functions may be called on any thread, also on several at once.
namespace burin {

/// How a stroke ends.
enum class Cap {
  butt,   ///< the chart ends where t leaves [0, length]
  round,  ///< half a geodesic disc of the stroke's radius beyond each end
};

/// How coordinates are defined where the stroke bends sharper than its radius.
enum class Join {
  round,    ///< by geodesic distance alone: around the outside of the bend t hardly changes, inside it jumps
  smooth,   ///< t is spread evenly along the lines of constant d through the bend, inside as far as |grad t|
            ///< stays below about 2
  miter,    ///< the legs' straight coordinates continue until they meet; below 120 degrees, else round
  overlap,  ///< legs and bends have separate sheets of all vertices that lie beside them, out to the radius
};

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

/// The surface from which a later visit of a stroke to a vertex displaces it.
enum class Accumulate {
  from_base,     ///< the surface before the stroke; Overlap defines how the visits combine
  from_current,  ///< the surface after the stroke's earlier visits, along the normals of that surface
};

/// What becomes of the solid that a brush makes along a stroke.
enum class SolidOperation {
  none,          ///< there is none: the stroke does to the surface what the brush does without
  separate,      ///< a part of its own, beside the surface
  unite,         ///< it becomes part of the surface
  difference,    ///< the surface loses it
  intersection,  ///< the surface keeps only what is in it
};

/// Whether the triangles of the surface change.
inline bool merges(SolidOperation operation) { return operation > SolidOperation::separate; }

/// Whether a stroke is closed.
enum class Closure {
  open,
  closed,
  automatic,  ///< closed if CurveTracer::came_back()
};

/// How the tremor of the hand is filtered out of a stroke.
struct Stabilising {
  enum class Kind {
    none,
    string,       ///< the pen pulls the brush by a string, so the brush moves along a tractrix
    exponential,  ///< the brush is at the mean of the pen's positions, weighted by exp(-age / amount)
  };
  Kind kind = Kind::none;
  double amount = 1;  ///< > 0; string: length in units of the samples' space; exponential: seconds
};

// The names of the choices in command lines, suites and recordings.

/// A choice and its name.
template <class Choice>
struct Named {
  std::string_view name;
  Choice choice;
};
// Clang 14 cannot deduce it by itself.
template <class Choice>
Named(std::string_view, Choice) -> Named<Choice>;

inline constexpr std::array named_caps{Named{"round", Cap::round}, Named{"butt", Cap::butt}};
inline constexpr std::array named_joins{Named{"round", Join::round}, Named{"smooth", Join::smooth},
                                        Named{"miter", Join::miter}, Named{"overlap", Join::overlap}};
inline constexpr std::array named_overlaps{Named{"strongest", Overlap::strongest},
                                           Named{"latest", Overlap::latest},
                                           Named{"max", Overlap::max},
                                           Named{"min", Overlap::min},
                                           Named{"add", Overlap::add},
                                           Named{"average", Overlap::average}};
inline constexpr std::array named_accumulations{Named{"base", Accumulate::from_base},
                                                Named{"current", Accumulate::from_current}};
inline constexpr std::array named_solids{
    Named{"none", SolidOperation::none}, Named{"separate", SolidOperation::separate},
    Named{"union", SolidOperation::unite}, Named{"difference", SolidOperation::difference},
    Named{"intersection", SolidOperation::intersection}};
inline constexpr std::array named_closures{Named{"yes", Closure::closed}, Named{"no", Closure::open},
                                           Named{"auto", Closure::automatic}};

template <class Choice, std::size_t count>
constexpr std::string_view name_of(const std::array<Named<Choice>, count>& names, Choice choice) {
  return std::ranges::find(names, choice, &Named<Choice>::choice)->name;
}

}  // namespace burin
