// Fills a column for each parameter that dynamics drive; the others keep one value for all.
#include <burin/deform/evaluate/batch_params.h>

#include <cstddef>

namespace burin {

const burin_params& BatchParams::fill(const burin_params& params, const NodeDynamics& dynamics,
                                      std::span<const Index> nodes) {
  const auto varying = dynamics.params();
  if (varying.empty()) return params;
  values_.assign(params.values, params.values + params.count);
  numbers_.resize(varying.size() * nodes.size());
  float* number = numbers_.data();
  for (std::size_t k = 0; k < varying.size(); ++k) {
    values_[varying[k].index].number = {number, 1, 0};
    for (const Index node : nodes) *number++ = dynamics.value(node, k);
  }
  params_ = {sizeof(burin_params), params.count, values_.data()};
  return params_;
}

}  // namespace burin
