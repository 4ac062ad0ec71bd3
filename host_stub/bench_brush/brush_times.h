#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "bench/bootstrap.h"

namespace burin {

/// Whose brush it is.
enum class BrushOrigin { plugin, other, stock };

/// Processes in which all brushes are measured.
inline constexpr int measuring_processes = 10;

/// The times of a brush's evaluate, each the least of the rounds of one process.
struct BrushTimes {
  std::string id;
  BrushOrigin origin = BrushOrigin::plugin;
  double budget = 0;                ///< what its author promised, as a multiple of copying; 0: nothing
  std::vector<double> nanoseconds;  ///< [process] a node
  std::vector<double> multiples;    ///< [process] of copying the declared inputs
};

struct BrushModules {
  std::filesystem::path plugin;
  std::filesystem::path other;  ///< another version to compare with; may be empty
  std::filesystem::path stock;  ///< folder of the stock brushes
};

/// Measures all brushes of the modules so many rounds in each process. Stock brushes that cannot begin a
/// stroke with their defaults, or make nothing but solids, are left out. Throws Error for a plugin that
/// cannot be loaded, whose brushes cannot begin, or that ends the process.
std::vector<BrushTimes> measure_brushes(const BrushModules& modules, int rounds);

/// The geometric mean of ratios, one of each process, with Student's interval of 95 % of their logarithms.
Estimate mean_ratio(const std::vector<double>& ratios);

/// The times of one brush as a multiple of another's, process by process.
Estimate ratio_of(const BrushTimes& one, const BrushTimes& other);

/// The multiple of copying.
Estimate multiple_of(const BrushTimes& brush);

}  // namespace burin
