#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace burin::math {

/// The median of one or more values, the upper one of an even number of them. Reorders the values.
template <class Number>
Number median(std::vector<Number>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace burin::math
