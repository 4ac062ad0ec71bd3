#pragma once
#include <burin/chart/live_chart.h>
#include <burin/surface/surface.h>

#include <span>
#include <string_view>

namespace burin {

/// What a vertex does where a stroke overlaps itself and each sheet would displace it. All but `latest` give
/// the same whichever way the stroke runs.
enum class Overlap {
  latest,   ///< as the sheet of the highest t says
  max,      ///< as the sheet that moves it farthest outward along the vertex normal
  min,      ///< as the sheet that moves it farthest inward
  add,      ///< the sum of all sheets
  average,  ///< their mean
};

/// Where vertices go: [i] of `places` is for vertices[i], back to its base when it has no node.
/// `displacement`: [slot] of the chart, in the node's (e1, e2, n). A vertex with one node goes where
/// displaced() puts it, bit for bit. Throws ContractError naming brush and (t, d) where that is beyond the
/// range of floats.
void blend_sheets(const Surface& surface, const LiveChart& chart, std::span<const Vec3f> displacement,
                  std::span<const Index> vertices, Overlap overlap, std::string_view brush,
                  std::span<Vec3f> places);

}  // namespace burin
