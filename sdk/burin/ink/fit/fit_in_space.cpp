// Brings strokes in space to a surface.
#include <burin/base/parallel.h>
#include <burin/base/vector.h>
#include <burin/ink/fit/fit_in_space.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace burin {
namespace {

using Box = Eigen::AlignedBox3d;

Box box_of(const std::vector<RecordedStroke>& strokes) {
  Box box;
  for (const RecordedStroke& stroke : strokes)
    for (const Sample& sample : stroke.samples) box.extend(sample.position);
  return box;
}

Box box_of(const Surface& surface) {
  Box box;
  for (const Vec3f& position : surface.positions) box.extend(position.cast<double>());
  return box;
}

}  // namespace

void fit_into_box_of(std::vector<RecordedStroke>& strokes, const Surface& surface) {
  constexpr double least_share = 1e-9;  // of the longest side of the strokes: a side that limits nothing
  const Box from = box_of(strokes), to = box_of(surface);
  const double longest = from.sizes().maxCoeff();
  double scale = longest > 0 ? to.sizes().maxCoeff() / longest : 1;
  // A plane has no depth; sides in which the surface is flat do not limit the strokes.
  for (int axis = 0; axis < 3; ++axis)
    if (from.sizes()[axis] > least_share * longest && to.sizes()[axis] > least_share * to.sizes().maxCoeff())
      scale = std::min(scale, to.sizes()[axis] / from.sizes()[axis]);
  for (RecordedStroke& stroke : strokes)
    for (Sample& sample : stroke.samples)
      sample.position = to.center() + scale * (sample.position - from.center());
}

void put_on_surface(std::vector<RecordedStroke>& strokes, const Surface& surface) {
  constexpr std::size_t samples_at_once = 256;
  constexpr float anywhere = std::numeric_limits<float>::max();
  const Picker picker(surface);
  for (RecordedStroke& stroke : strokes)
    parallel_blocks(stroke.samples.size(), samples_at_once, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        Vec3d& position = stroke.samples[i].position;
        if (const auto nearest = picker.closest(position.cast<float>(), anywhere))
          position = nearest->position.cast<double>();
      }
    });
}

}  // namespace burin
