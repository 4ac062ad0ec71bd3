#pragma once
#include <cstdint>

namespace burin::plugin {

/// Random numbers that are asked for by name instead of drawn in turn: the same seed, counter and channel
/// give the same bits on every platform, thread and evaluation of a node. A brush takes Stroke::seed(), for
/// the counter what it makes its things of (the number of a tile along the stroke, say: a mirror image of
/// the stroke then gets the mirror image of the things), and a channel for each use.
///
/// Number `counter` of `channel` is output `counter` of a SplitMix64 generator [Steele, Lea and Flood, "Fast
/// splittable pseudorandom number generators", OOPSLA 2014], whose seed is output `channel` of the one that
/// has been seeded with `seed`.
class Random {
 public:
  explicit constexpr Random(std::uint64_t seed) : seed_(seed) {}

  constexpr std::uint64_t bits(std::uint64_t counter, std::uint64_t channel = 0) const {
    return splitmix64(splitmix64(seed_, channel), counter);
  }

  /// Uniform in [0, 1): one of the 2^24 multiples of 2^-24.
  constexpr float operator()(std::uint64_t counter, std::uint64_t channel = 0) const {
    return static_cast<float>(bits(counter, channel) >> 40) * 0x1p-24f;
  }

  /// Output number `index`, from 0, of the generator SplitMix64 seeded with `seed`.
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
