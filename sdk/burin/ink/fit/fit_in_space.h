#pragma once
#include <burin/stroke/recording.h>
#include <burin/surface/picker.h>

#include <vector>

namespace burin {

/// Scales strokes in space uniformly and moves them so that their bounding box fits into that of a surface,
/// with the same centre.
void fit_into_box_of(std::vector<RecordedStroke>& strokes, const Surface& surface);

/// Moves each sample to the place of the surface that is nearest to it.
void put_on_surface(std::vector<RecordedStroke>& strokes, const Surface& surface);

}  // namespace burin
