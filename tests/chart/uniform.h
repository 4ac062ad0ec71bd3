#pragma once
#include <random>

namespace burin::test {

/// A uniform random number in [0, 1), the same on every platform (unlike std::uniform_real_distribution).
inline double uniform(std::mt19937& random) { return static_cast<double>(random()) / 4294967296.; }

}  // namespace burin::test
