#pragma once
#include <burin/stroke/recording.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include "bench/suite.h"

namespace burin {

/// A recording in object space of the stroke with this radius: from its first place straight on, that is, in
/// steps of about an edge to closest points, the direction carried along by parallel transport. 240 samples a
/// second. Throws Error when there is no surface within the size of the object, or it ends on the way.
Recording make_straight_stroke(const Surface& surface, const Picker& picker, const StraightStroke& stroke,
                               double radius);

}  // namespace burin
