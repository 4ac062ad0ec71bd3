#pragma once
#include <cstdint>

namespace burin::plugin {

/// A counter-based random generator: the same seed, counter and channel give the same bits on every platform,
/// on every thread and in every evaluation of a node. A brush uses Stroke::seed(), a counter that identifies
/// what it draws, and a channel for each use. With the number of a tile along the stroke as counter, for
/// example, a mirror image of the stroke gets the mirror image of its tiles.
///
/// Number `counter` of `channel` is output `counter` of a SplitMix64 generator [Steele, Lea and Flood, "Fast
/// splittable pseudorandom number generators", OOPSLA 2014] whose seed is output `channel` of the generator
/// seeded with `seed`.
class Random {
 public:
  explicit constexpr Random(std::uint64_t seed) : seed_(seed) {}

  /// 64 random bits.
  constexpr std::uint64_t bits(std::uint64_t counter, std::uint64_t channel = 0) const {
    return splitmix64(splitmix64(seed_, channel), counter);
  }

  /// Uniform in [0, 1): one of the 2^24 multiples of 2^-24.
  constexpr float operator()(std::uint64_t counter, std::uint64_t channel = 0) const {
    return static_cast<float>(bits(counter, channel) >> 40) * 0x1p-24f;
  }

  /// Output number `index`, from 0, of a SplitMix64 generator seeded with `seed`.
  static constexpr std::uint64_t splitmix64(std::uint64_t seed, std::uint64_t index) {
    std::uint64_t x = seed + 0x9E3779B97F4A7C15u * (index + 1);
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
  }

 private:
  std::uint64_t seed_;
};

}  // namespace burin::plugin
