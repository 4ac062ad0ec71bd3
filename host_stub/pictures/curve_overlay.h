#pragma once
#include <burin/stamp/files/picture.h>
#include <burin/stroke/curve/surface_curve.h>

#include "pictures/pencil.h"

namespace burin {

inline constexpr Ink dark_ink = {20, 20, 20};

/// Draws the visible part of a curve over a picture that was rendered with this camera. Parts at most `depth`
/// (object units) below the surface are visible too.
void draw_curve(Picture& picture, const Camera& camera, const Picker& picker, const SurfaceCurve& curve,
                double depth, const Ink& ink = dark_ink);

}  // namespace burin
