#pragma once
#include <stdexcept>

namespace burin {

/// A measurement that does not meet expectations, as opposed to an error of input or usage. The exit code is
/// 1.
class Regression : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace burin
