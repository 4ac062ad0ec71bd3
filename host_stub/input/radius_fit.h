#pragma once
#include <burin/surface/surface.h>

#include <string>
#include <vector>

namespace burin {

/// The mean length of the edges or links of the surface, object units.
double mean_edge_length(const Surface& surface);

/// Warns if a radius, object units, is less than half of the mean edge, so that strokes meet hardly any
/// vertex. `path` is the surface's file.
void warn_of_small_radii(const std::string& path, const Surface& surface, const std::vector<double>& radii);

/// Warns if a radius, object units, is greater than the whole surface, so that strokes are shorter than it.
void warn_of_great_radii(const std::string& path, const Surface& surface, const std::vector<double>& radii);

}  // namespace burin
