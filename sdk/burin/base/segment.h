#pragma once
#include <burin/base/vector.h>

#include <algorithm>

namespace burin {

/// The point of a segment nearest to another point, as the share of the way to its second end, 0..1; 0 if the
/// ends coincide. Any thread.
template <class Scalar>
Scalar share_on_segment(const Eigen::Matrix<Scalar, 3, 1>& from, const Eigen::Matrix<Scalar, 3, 1>& to,
                        const Eigen::Matrix<Scalar, 3, 1>& point) {
  const Eigen::Matrix<Scalar, 3, 1> way = to - from;
  const Scalar squared = way.squaredNorm();
  return squared > 0 ? std::clamp((point - from).dot(way) / squared, Scalar{0}, Scalar{1}) : 0;
}

}  // namespace burin
