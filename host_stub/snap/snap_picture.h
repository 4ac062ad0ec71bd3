#pragma once
#include <burin/feature/snap.h>
#include <burin/stamp/files/picture.h>
#include <burin/stroke/camera.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>

#include <span>
#include <vector>

namespace burin::command {

/// A stroke before and after it was snapped.
struct SnappedStroke {
  SurfaceCurve stroke;
  std::vector<SurfaceCurve> moved;  ///< one curve, or those parts of a line that are followed
  std::vector<SnapImage> images;    ///< [iteration]
};

/// The surface with the strokes before (black) and after (red). The images of the feature's function over
/// (t, d) of the first stroke's first and last iterations are at the top: t to the right, d upwards, bright
/// where the function is great, with the stroke (black) and the path (red) in them. `depth`: object units by
/// which lines may be below the surface and are drawn still.
Picture snap_picture(const Surface& surface, const Picker& picker, const Camera& camera,
                     std::span<const SnappedStroke> strokes, double depth);

}  // namespace burin::command
