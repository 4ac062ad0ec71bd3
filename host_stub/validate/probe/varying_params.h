#pragma once
#include <burin/abi/brush.h>

#include <cstddef>
#include <vector>

#include "validate/probe/nodes.h"

namespace burin::validate {

/// Values of parameters, of which dynamic ones have another number for each node, around the constant one.
class VaryingParams {
 public:
  /// `constant`: the values of the stroke, which live as long as the object.
  VaryingParams(const burin_brush_descriptor& brush, const burin_params& constant, const Nodes& nodes);
  VaryingParams(const VaryingParams&) = delete;
  VaryingParams& operator=(const VaryingParams&) = delete;

  /// The values as a batch has them that begins with a certain node.
  class Part {
   public:
    explicit Part(std::vector<burin_param_value> values) : values_(std::move(values)) {}
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;
    const burin_params& abi() const { return params_; }

   private:
    std::vector<burin_param_value> values_;
    burin_params params_{sizeof(burin_params), static_cast<std::uint32_t>(values_.size()), values_.data()};
  };

  Part from(std::size_t node) const;

 private:
  std::vector<burin_param_value> values_;    ///< of a batch that begins with the first node
  std::vector<std::vector<float>> numbers_;  ///< what dynamic parameters point to
};

}  // namespace burin::validate
