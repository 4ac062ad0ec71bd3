#pragma once
#include <burin/base/vector.h>

#include <vector>

// The functions may be called on any thread, also on several at once.
namespace burin {

/// Colours and masks of a surface's vertices. An empty array means that no vertex is painted.
struct Paint {
  std::vector<Vec4f> colour;  ///< [vertex] linear RGB and coverage, each 0..1
  std::vector<float> mask;    ///< [vertex] 0 = protected .. 1 = free

  /// Of what is not painted.
  static Vec4f bare() { return {1, 1, 1, 0}; }

  Vec4f colour_of(Index vertex) const { return colour.empty() ? bare() : colour[vertex]; }  ///< linear RGBA
  float mask_of(Index vertex) const { return mask.empty() ? 1 : mask[vertex]; }             ///< 0..1
};

/// Colour and mask of one node or vertex in a form that can be added and averaged: linear red, green and blue
/// times coverage, coverage, mask.
using Tint = Eigen::Matrix<float, 5, 1>;

inline Tint tint_of(const Vec4f& colour, float mask) {
  Tint tint;
  tint << colour.head<3>() * colour.w(), colour.w(), mask;
  return tint;
}

inline Vec4f colour_of(const Tint& tint) {
  if (!(tint[3] > 0)) return Paint::bare();
  Vec4f colour;
  // In sums of tints a channel may exceed the coverage.
  colour << (tint.head<3>() / tint[3]).cwiseMin(1), tint[3];
  return colour;
}

}  // namespace burin
