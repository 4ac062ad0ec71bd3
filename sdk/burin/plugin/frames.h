#pragma once
#include <burin/plugin/batch.h>
#include <burin/plugin/detail/views.h>

#include <cstddef>

namespace burin::plugin {

/// The components of a vector in the frame of its node: along e1, e2 and the normal.
struct FrameComponents {
  float along, across, up;
};

/// The scalar product of vectors i.
inline float dot(const Vectors& a, const Vectors& b, std::size_t i) {
  return a.x[i] * b.x[i] + a.y[i] * b.y[i] + a.z[i] * b.z[i];
}

/// The frames (e1, e2, n) of a batch's nodes. The brush must declare BURIN_INPUT_NORMAL and BURIN_INPUT_E1.
class Frames {
 public:
  explicit Frames(const Batch& in)
      : e1_(in.e1()), normal_(in.normal()), side_(in.stroke.mirrored() ? -1.0f : 1.0f) {}

  /// Converts vector i from object space to the frame of node i, in which Outputs and Batch::displacement()
  /// are.
  FrameComponents components(const Vectors& vectors, std::size_t i) const {
    const float x = vectors.x[i], y = vectors.y[i], z = vectors.z[i];
    const float e2_x = normal_.y[i] * e1_.z[i] - normal_.z[i] * e1_.y[i];
    const float e2_y = normal_.z[i] * e1_.x[i] - normal_.x[i] * e1_.z[i];
    const float e2_z = normal_.x[i] * e1_.y[i] - normal_.y[i] * e1_.x[i];
    return {dot(vectors, e1_, i), side_ * (x * e2_x + y * e2_y + z * e2_z), dot(vectors, normal_, i)};
  }

 private:
  const Vectors e1_, normal_;
  const float side_;  // -1 for mirrored strokes, whose e2 points to the right of the direction of travel
};

}  // namespace burin::plugin
