#pragma once
#include <burin/deform/blend/sheet.h>
#include <burin/deform/overlap.h>

#include <vector>

namespace burin {

/// What several sheets of one vertex do together: how far it goes, in object space. `radius`: of the stroke,
/// object units. Except for `latest` the order of the sheets does not matter, to the last bit.
Vec3d combined_move(std::vector<Sheet> sheets, Overlap overlap, double radius);

/// The same for colours and masks; `before`: those of the vertex without the stroke.
Tint combined_tint(std::vector<Sheet> sheets, Overlap overlap, const Tint& before);

}  // namespace burin
