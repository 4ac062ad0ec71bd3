#pragma once
#include <burin/deform/blend/sheet.h>
#include <burin/deform/overlap.h>

#include <vector>

namespace burin {

/// The combined displacement of a vertex with several sheets, in object space. `radius` is that of the
/// stroke, object units. Except for Overlap::latest, the order of the sheets does not change any bit of the
/// result.
Vec3d combined_move(std::vector<Sheet> sheets, Overlap overlap, double radius);

/// The combined colour and mask of a vertex with several sheets; `before` are those of the vertex without the
/// stroke.
Tint combined_tint(std::vector<Sheet> sheets, Overlap overlap, const Tint& before);

}  // namespace burin
