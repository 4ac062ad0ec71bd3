#pragma once
#include <burin/deform/blend/sheet.h>

#include <span>
#include <vector>

namespace burin {

// How much each of a vertex's sheets counts, [sheet]; shares add up to 1. A sheet weighs nothing at its rim
// and all from three quarters of its half width inside of it, so that a sheet that begins or ends changes
// nothing where it does; and one that is alone has all the share, whatever it weighs.
using Shares = std::vector<double>;

/// By weight.
Shares mean_shares(std::span<const Sheet> sheets);

/// Sheets lie over one another, each as opaque as it weighs: those of greater `keys` on top.
Shares stacked_shares(std::span<const Sheet> sheets, std::span<const double> keys);

/// The same without a step where the order changes: of sheets whose keys differ by less than `soft` (> 0)
/// either counts, the upper one the more. In proportion to the square of the number of sheets.
Shares softly_stacked_shares(std::span<const Sheet> sheets, std::span<const double> keys, double soft);

/// The later ones of an image on top. Images are drawn at the same time: they count as those of their sheets
/// that count lie near to the stroke.
Shares latest_shares(std::span<const Sheet> sheets);

}  // namespace burin
