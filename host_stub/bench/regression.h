#pragma once
#include <stdexcept>

namespace burin {

/// What was measured is not as it should be: no fault of a file or of the usage. The command ends with 1.
class Regression : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace burin
