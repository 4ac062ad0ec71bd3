#pragma once
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <random>

namespace burin {

/// Random numbers that are the same with every standard library, for which the standard's distributions are
/// not.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : random_(seed) {}

  double between(double low, double high) {
    return low + static_cast<double>(random_() >> 11) * 0x1p-53 * (high - low);
  }
  /// 0 to count - 1.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }
  /// True once in so many times.
  bool once_in(std::size_t times) { return below(times) == 0; }
  template <class T>
  T one_of(std::initializer_list<T> choices) {
    return choices.begin()[below(choices.size())];
  }
  std::uint64_t bits() { return random_(); }

 private:
  std::mt19937_64 random_;
};

}  // namespace burin
