#pragma once
#include <burin/plugin/falloff.h>
#include <burin/plugin/random.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace burin::plugin {

/// Gradient noise in the plane [Perlin, "Improving noise", SIGGRAPH 2002]: 0 at all integer (x, y), with
/// random slopes there, smooth between. Its values are within [-1, 1], with mean 0 and root mean square 0.33.
/// It is nearly band-limited: 0.7 % of its energy is above one cycle per cell along either axis, 0.01 % above
/// two. O(1) per value.
class GradientNoise {
 public:
  explicit constexpr GradientNoise(std::uint64_t seed) : random_(seed) {}

  /// The noise at (x, y), in cells. `period`: the noise at x and x + period is the same; 0 means not
  /// periodic.
  float operator()(double x, double y, std::int64_t period = 0) const {
    const double left = std::floor(x), low = std::floor(y);
    const auto u = static_cast<float>(x - left), v = static_cast<float>(y - low);
    const auto j = static_cast<std::int64_t>(low);
    const std::int64_t i = wrapped(static_cast<std::int64_t>(left), period), next = wrapped(i + 1, period);
    const float below = mix(slope(i, j, u, v), slope(next, j, u - 1, v), u);
    const float above = mix(slope(i, j + 1, u, v - 1), slope(next, j + 1, u - 1, v - 1), u);
    return 1.41421356f * mix(below, above, v);  // unit slopes reach sqrt(1/2) in the middle of a cell
  }

 private:
  static std::int64_t wrapped(std::int64_t i, std::int64_t period) {
    if (period == 0) return i;
    const std::int64_t rest = i % period;
    return rest < 0 ? rest + period : rest;
  }

  /// Interpolates from a to b with zero slope and curvature at both ends.
  static float mix(float a, float b, float x) { return a + (b - a) * (x * x * x * (x * (x * 6 - 15) + 10)); }

  /// The linear function that is 0 at lattice point (i, j) and has a random unit gradient, at the offset (u,
  /// v) from there. The gradient is a rational point of a quarter circle, turned by a multiple of 90 degrees,
  /// which needs no sines and so gives the same bits everywhere.
  float slope(std::int64_t i, std::int64_t j, float u, float v) const {
    const std::uint64_t bits = random_.bits(static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(j));
    const float s = static_cast<float>(bits >> 40) * 0x1p-24f;
    const float cosine = (1 - s * s) / (1 + s * s), sine = 2 * s / (1 + s * s);
    const float along = cosine * u + sine * v, beside = cosine * v - sine * u;
    const float turned = bits & 1 ? beside : along;
    return bits & 2 ? -turned : turned;
  }

  Random random_;
};

/// A sum of octaves of gradient noise. Each octave has cells half as long as the one before and `gain` times
/// its height. An octave fades out where the mesh is too coarse to show it. O(octaves) per value.
class FractalNoise {
 public:
  /// How many octaves there are and how much each adds.
  struct Octaves {
    int count = 6;            ///< at least 1
    float gain = 0.5f;        ///< > 0
    std::int64_t period = 0;  ///< period in x, cells of the first octave; 0 means not periodic
  };

  FractalNoise(std::uint64_t seed, const Octaves& octaves) : seed_(seed), octaves_(octaves) {}

  /// The noise at (x, y) for a node whose cell has this size; all in cells of the first octave. The
  /// value is within [-1, 1].
  float operator()(double x, double y, double footprint_x, double footprint_y) const {
    return shaped(x, y, footprint_x, footprint_y, [](float noise) { return noise; });
  }

  /// The noise with a function applied to every octave. The function's values should have mean 0 and
  /// lie within [-1, 1].
  template <class Shape>
  float shaped(double x, double y, double footprint_x, double footprint_y, const Shape& shape) const {
    double cells = 1;  // cells of this octave per cell of the first
    float height = 1, sum = 0, heights = 0;
    for (int octave = 0; octave < octaves_.count; ++octave) {
      const auto index = static_cast<std::uint64_t>(octave);
      const float shown = visibility(cells * std::max(footprint_x, footprint_y));
      heights += height;
      if (shown > 0) {
        const GradientNoise noise(Random::splitmix64(seed_, index));
        sum += shown * height * shape(noise(cells * x, cells * y, octaves_.period << index));
      }
      height *= octaves_.gain;
      cells *= 2;
    }
    return sum / heights;
  }

  /// The weight of an octave: 1 if a cell of the noise is at least four footprints long, 0 if it is at most
  /// two. `footprint`: in cells of the octave.
  static float visibility(double footprint) { return smooth_step(static_cast<float>(2 - 4 * footprint)); }

 private:
  std::uint64_t seed_;
  Octaves octaves_;
};

}  // namespace burin::plugin
