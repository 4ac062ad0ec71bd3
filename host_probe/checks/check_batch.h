#pragma once
#include <burin/abi/brush.h>

#include "../strokes.h"

namespace burin_probe {

/// Checks the context of a call between begin and end.
void check_context(const Stroke& stroke, const burin_stroke_context& context);

/// Checks that a batch of a brush that reads `inputs` has these and no others. Returns whether all are there.
bool check_arrays(const burin_batch& batch, std::uint64_t inputs);

/// Does that, and checks the nodes of a batch for evaluate.
bool check_batch(const burin_stroke_context& context, const burin_batch& batch, std::uint64_t inputs);

/// Checks the outputs before anything is written, where a brush writes `written` of them. Returns whether all
/// arrays are there.
bool check_outputs(const burin_batch& batch, const burin_outputs& outputs, std::uint64_t written);

/// What the probe writes as displacement along the normal at a node in a pass of so many, object units.
float displacement(const burin_stroke_context& context, const burin_batch& batch, std::uint32_t node,
                   std::uint32_t pass, std::uint32_t passes);

/// Checks that the batch has what the previous pass wrote.
void check_passes(const burin_stroke_context& context, const burin_batch& batch, std::uint32_t passes);

}  // namespace burin_probe
