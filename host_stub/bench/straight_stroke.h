#pragma once
#include <burin/stroke/recording.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include "bench/suite.h"

namespace burin {

/// Makes a recording, in object space, of a straight stroke with this radius, object units. It follows the
/// surface in steps of about an edge to closest points, with the direction parallel transported, at 240
/// samples per second. Throws Error if there is no surface within the size of the object, or if the surface
/// ends on the way.
Recording make_straight_stroke(const Surface& surface, const Picker& picker, const StraightStroke& stroke,
                               double radius);

}  // namespace burin
