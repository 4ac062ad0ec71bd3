#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "bench/bootstrap.h"

namespace burin {

/// Whose brush it is.
enum class BrushOrigin { plugin, other, stock };

/// The times of a brush's evaluate, measured round by round in turn with those of other brushes.
struct BrushTimes {
  std::string id;
  BrushOrigin origin = BrushOrigin::plugin;
  double budget = 0;                ///< what its author promised, as a multiple of copying; 0: nothing
  std::vector<double> nanoseconds;  ///< [round] a node
  std::vector<double> multiples;    ///< [round] of copying the declared inputs
};

struct BrushModules {
  std::filesystem::path plugin;
  std::filesystem::path other;  ///< another version to compare with; may be empty
  std::filesystem::path stock;  ///< folder of the stock brushes
};

/// Measures all brushes of the modules. Stock brushes that cannot begin a stroke with their defaults, or
/// make nothing but solids, are left out. Throws Error for a plugin that cannot be loaded or whose brushes
/// cannot begin.
std::vector<BrushTimes> measure_brushes(const BrushModules& modules, int rounds);

/// The times of one brush as a multiple of another's, round by round.
Estimate ratio_of(const BrushTimes& one, const BrushTimes& other);

/// The multiple of copying.
Estimate multiple_of(const BrushTimes& brush);

}  // namespace burin
