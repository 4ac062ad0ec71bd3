#pragma once
#include <burin/base/vector.h>
#include <burin/deform/evaluate/param_dynamics.h>

#include <cstddef>
#include <vector>

namespace burin {

/// Strength and parameters at each node of a stroke, as the pen's dynamics drive them.
class NodeDynamics {
 public:
  /// `dynamics` must outlive the object; null if nothing varies.
  explicit NodeDynamics(const ParamDynamics* dynamics)
      : dynamics_(dynamics && dynamics->any() ? dynamics : nullptr) {}

  bool any() const { return dynamics_ != nullptr; }

  void resize(std::size_t slots);

  /// Sets the node's values to those at its point of the curve; returns whether any differs from before.
  /// Several threads may call this at once for different slots. Requires any().
  bool update(Index slot, const PenAt& at, double loop);

  /// The factor on the strength.
  float strength(Index slot) const { return any() ? values_[slot * stride()] : 1; }

  /// The parameters that vary, and the value of the k-th of them.
  std::span<const ParamDynamics::Param> params() const {
    return any() ? std::span(dynamics_->params()) : std::span<const ParamDynamics::Param>();
  }
  float value(Index slot, std::size_t k) const { return values_[slot * stride() + 1 + k]; }

 private:
  std::size_t stride() const { return 1 + dynamics_->params().size(); }

  const ParamDynamics* dynamics_;
  std::vector<float> values_;  ///< [slot] the factor on the strength, then one value per parameter
};

}  // namespace burin
