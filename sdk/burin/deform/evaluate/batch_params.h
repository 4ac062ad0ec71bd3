#pragma once
#include <burin/abi/param.h>
#include <burin/deform/evaluate/node_dynamics.h>

#include <span>
#include <vector>

namespace burin {

/// The parameters of one batch: those that dynamics drive have one number per element.
class BatchParams {
 public:
  /// `params` are the values before dynamics. The result is valid until the next call.
  const burin_params& fill(const burin_params& params, const NodeDynamics& dynamics,
                           std::span<const Index> nodes);

 private:
  std::vector<burin_param_value> values_;
  std::vector<float> numbers_;  ///< parameter by parameter, one number per element
  burin_params params_{};
};

}  // namespace burin
