#pragma once
#include <burin/stamp/files/picture.h>
#include <burin/stroke/curve/surface_curve.h>

namespace burin {

/// Draws the visible part of a curve as a dark line over a picture that was rendered with this camera. Parts
/// at most `depth` (object units) below the surface are visible too.
void draw_curve(Picture& picture, const Camera& camera, const Picker& picker, const SurfaceCurve& curve,
                double depth);

}  // namespace burin
