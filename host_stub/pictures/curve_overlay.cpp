// Draws a curve segment by segment with a pencil that leaves out what the surface hides.
#include "pictures/curve_overlay.h"

namespace burin {

void draw_curve(Picture& picture, const Camera& camera, const Picker& picker, const SurfaceCurve& curve,
                double depth, const Ink& ink) {
  LineLayer layer(picture.width, picture.height);
  Pencil pencil(layer, camera, picker, depth);
  for (std::size_t i = 0; i < curve.segment_count(); ++i) {
    pencil.draw(curve.points[i].at.position.cast<double>(),
                curve.points[curve.next(i)].at.position.cast<double>(), ink);
  }
  layer.blend(picture);
}

}  // namespace burin
