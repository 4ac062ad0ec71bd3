#pragma once
#include <burin/deform/blend/sheet.h>

#include <span>
#include <vector>

namespace burin {

// The share of each of a vertex's sheets in the result; the shares of all sheets add up to 1. The weight of a
// sheet is 0 at its rim and 1 from three quarters of its half width inside the rim, so that the result is
// continuous where a sheet begins or ends. A single sheet has the share 1 whatever its weight.
using Shares = std::vector<double>;

/// Shares in proportion to the weights.
Shares mean_shares(std::span<const Sheet> sheets);

/// Sheets are stacked with greater `keys` on top; the weight of a sheet is its opacity. O(s log s) for s
/// sheets.
Shares stacked_shares(std::span<const Sheet> sheets, std::span<const double> keys);

/// Sheets are stacked by `keys`, but shares change continuously where the order changes: of two sheets whose
/// keys differ by less than `soft` (> 0) both count, the upper one more. O(s^2) for s sheets.
Shares softly_stacked_shares(std::span<const Sheet> sheets, std::span<const double> keys, double soft);

/// Within each image, later sheets are on top. Images are drawn at the same time; each is weighted by how
/// near to the stroke its visible sheets lie.
Shares latest_shares(std::span<const Sheet> sheets);

}  // namespace burin
