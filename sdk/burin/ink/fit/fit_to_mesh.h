#pragma once
#include <burin/stroke/recording.h>
#include <burin/surface/surface.h>

#include <vector>

namespace burin {

/// Scales strokes uniformly and moves them in the view so that they are as large as possible with every
/// sample, and the way between samples, where the camera sees the surface without a step. Returns false, and
/// changes nothing, if there is no such place.
bool fit_to_mesh(std::vector<RecordedStroke>& strokes, const Camera& camera, const Surface& surface);

}  // namespace burin
