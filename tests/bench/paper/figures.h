#pragma once
#include "page.h"
#include "scenes.h"

namespace burin::paper {

/// Each writes the table and the pictures that correspond to a figure of the paper, on the meshes that are
/// there.
void distance_figure(Page& page, const Scenes& scenes);  ///< 10
void dncp_figure(Page& page, const Scenes& scenes);      ///< 11
void arap_figure(Page& page, const Scenes& scenes);      ///< 12
void times_figure(Page& page, const Scenes& scenes, int strokes,
                  double largest_radius);               ///< 13; in mean edges
void hairpin_figure(Page& page, const Scenes& scenes);  ///< 14

}  // namespace burin::paper
