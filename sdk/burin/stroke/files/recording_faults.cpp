// Checks the values of a recording.
#include <burin/stroke/files/recording_faults.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

bool finite(double value) { return std::isfinite(value); }

bool invertible(const Mat4d& matrix) {
  return matrix.allFinite() && Eigen::FullPivLU<Eigen::Matrix4d>(matrix).isInvertible();
}

}  // namespace

std::string_view validation_error(const Camera& camera) {
  if (!invertible(camera.view)) return "camera: the view matrix has no inverse";
  if (!invertible(camera.projection)) return "camera: the projection matrix has no inverse";
  if (!(camera.projection * camera.view).inverse().allFinite()) return "camera: the matrices overflow";
  if (camera.width <= 0 || camera.height <= 0) return "camera: the viewport is empty";
  return {};
}

std::string_view validation_error(const Dynamic& dynamic) {
  const std::vector<double>& curve = dynamic.curve;
  if (curve.empty() || curve.size() % 2 != 0) return "a dynamic's curve must be pairs of numbers x y";
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (!finite(static_cast<float>(curve[i]))) return "a dynamic's curve must be finite";
    if (i >= 2 && i % 2 == 0 && !(curve[i] > curve[i - 2])) return "the x of a dynamic's curve must rise";
  }
  return {};
}

std::string_view validation_error(const Sample& sample) {
  const Pen& pen = sample.pen;
  if (!finite(sample.time)) return "time is not finite";
  if (!(sample.position.cwiseAbs().maxCoeff() <= std::numeric_limits<float>::max()) ||
      !sample.position.allFinite())
    return "the position is not finite, or too large";
  if (!(pen.pressure >= 0 && pen.pressure <= 1)) return "pressure must lie in 0..1";
  if (!finite(pen.tilt_x) || !finite(pen.tilt_y) || !finite(pen.twist)) return "tilt or twist is not finite";
  return {};
}

}  // namespace burin
