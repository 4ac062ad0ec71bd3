#pragma once
#include "scenes.h"

namespace burin::paper {

Drawing gentle_s();
Drawing bends();
Drawing sharp_bends();
Drawing gentle_on_ewer();

/// A hairpin whose turning radius is half of the stroke's.
Drawing hairpin();

}  // namespace burin::paper
