// Fits strokes into a viewport.
#include <burin/ink/fit/fit_to_view.h>

namespace burin {

Eigen::AlignedBox2d flat_box_of(const std::vector<RecordedStroke>& strokes) {
  Eigen::AlignedBox2d box;
  for (const RecordedStroke& stroke : strokes)
    for (const Sample& sample : stroke.samples) box.extend(sample.position.head<2>());
  return box;
}

void place(std::vector<RecordedStroke>& strokes, const Placement& placement) {
  for (RecordedStroke& stroke : strokes)
    for (Sample& sample : stroke.samples)
      sample.position.head<2>() =
          placement.to + placement.scale * (sample.position.head<2>() - placement.from);
}

Placement view_placement(const Eigen::AlignedBox2d& box, const Camera& camera, double margin) {
  constexpr double least_extent = 1e-30;  // keeps the scale finite
  const Eigen::Vector2d viewport(camera.width, camera.height);
  const double scale =
      ((1 - 2 * margin) * viewport.array() / box.sizes().array().max(least_extent)).minCoeff();
  return {scale, box.center(), viewport / 2};
}

void fit_to_view(std::vector<RecordedStroke>& strokes, const Camera& camera) {
  constexpr double margin = 0.1;
  place(strokes, view_placement(flat_box_of(strokes), camera, margin));
}

}  // namespace burin
