#pragma once
#include <burin/plugin/falloff.h>
#include <burin/plugin/random.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace burin::plugin {

/// Gradient noise in the plane [Perlin, "Improving noise", SIGGRAPH 2002]: 0 at all whole (x, y), with random
/// slopes there, smooth between. Within [-1, 1], of mean 0 and root mean square 0.33. It is band-limited: 0.7
/// % of its energy lies above one cycle a cell along either axis, 0.01 % above two.
class GradientNoise {
 public:
  explicit constexpr GradientNoise(std::uint64_t seed) : random_(seed) {}

  /// `period`: in x, cells, so that the noise at x and x + period is the same; 0 means none.
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

  /// From a to b with level tangents and no curvature at either.
  static float mix(float a, float b, float x) { return a + (b - a) * (x * x * x * (x * (x * 6 - 15) + 10)); }

  /// The plane through 0 at lattice point (i, j) with a random unit gradient, at (u, v) from there. Rational
  /// points of a quarter circle, turned by one of four quarters, need no sines: same bits everywhere.
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

/// Sum of gradient noises, octaves, each with cells half as long and `gain` as high as the one before. An
/// octave fades out where the mesh cannot show it.
class FractalNoise {
 public:
  struct Octaves {
    int count = 6;            ///< at least 1
    float gain = 0.5f;        ///< > 0
    std::int64_t period = 0;  ///< in x, cells of the first octave; 0 means none
  };

  FractalNoise(std::uint64_t seed, const Octaves& octaves) : seed_(seed), octaves_(octaves) {}

  /// At (x, y), measured in cells of the first octave as is the footprint of a node, its size in x and y.
  /// Within [-1, 1].
  float operator()(double x, double y, double footprint_x, double footprint_y) const {
    return shaped(x, y, footprint_x, footprint_y, [](float noise) { return noise; });
  }

  /// The same with a function on every octave, whose values should have mean 0 and lie within [-1, 1].
  template <class Shape>
  float shaped(double x, double y, double footprint_x, double footprint_y, const Shape& shape) const {
    double cells = 1;  // of this octave in one of the first
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

  /// 1 while a cell is at least four nodes long, 0 from two nodes on. `footprint`: in cells.
  static float visibility(double footprint) { return smooth_step(static_cast<float>(2 - 4 * footprint)); }

 private:
  std::uint64_t seed_;
  Octaves octaves_;
};

}  // namespace burin::plugin
