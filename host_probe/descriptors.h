#pragma once
#include <burin/abi/brush.h>

#include <cstdint>

namespace burin_probe {

/// Reads and writes everything, in several passes.
extern const burin_brush_descriptor everything;
/// Makes a solid and moves the curve; reads little.
extern const burin_brush_descriptor solid;

inline constexpr std::uint32_t brush_count = 2;
extern const burin_brush_descriptor* const descriptors[brush_count];

/// The parameters of both brushes, in their order.
enum Param : std::uint32_t { height, count, on, profile, tint, file, curve, text, passes, param_count };

}  // namespace burin_probe
