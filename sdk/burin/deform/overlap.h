#pragma once
#include <burin/stroke/stroke_choices.h>

#include <cstdint>

struct burin_brush_descriptor;

// The functions may be called on any thread, also on several at once.
namespace burin {

/// The rule to use for a brush with this many passes. Each pass starts from the result of the previous one,
/// so sums over many sheets would overshoot more with each pass; `strongest` is used instead of `add`.
Overlap over_passes(Overlap chosen, std::uint32_t passes);

/// The rule that a brush declares.
Overlap overlap_of(const burin_brush_descriptor& brush);

}  // namespace burin
