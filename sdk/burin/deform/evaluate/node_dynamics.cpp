// Evaluates the curves of dynamics at a node, in O(driven parameters).
#include <burin/deform/evaluate/node_dynamics.h>

#include <utility>

namespace burin {

void NodeDynamics::resize(std::size_t slots) {
  if (any()) values_.resize(slots * stride());
}

bool NodeDynamics::update(Index slot, const PenAt& at, double loop) {
  float* value = values_.data() + slot * stride();
  const auto set = [&value](float now) { return std::exchange(*value++, now) != now; };
  bool differs = set(dynamics_->strength(at, loop));
  for (const ParamDynamics::Param& param : dynamics_->params())
    differs |= set(ParamDynamics::value(param, at, loop));
  return differs;
}

}  // namespace burin
