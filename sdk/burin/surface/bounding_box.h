#pragma once
#include <burin/base/vector.h>

#include <span>

namespace burin {

inline double bounding_box_diagonal(std::span<const Vec3f> positions) {
  Eigen::AlignedBox3f box;
  for (const Vec3f& position : positions) box.extend(position);
  return (box.max().cast<double>() - box.min().cast<double>()).norm();
}

}  // namespace burin
