#pragma once
#include <burin/chart/live_chart.h>
#include <burin/deform/evaluate.h>
#include <burin/deform/paint.h>
#include <burin/surface/surface.h>

#include <limits>
#include <span>
#include <string_view>

namespace burin {

/// What a vertex does where a stroke overlaps itself and each sheet would displace or tint it. All but
/// `latest` give the same whichever way the stroke runs.
enum class Overlap {
  latest,   ///< as the sheet of the highest t says
  max,      ///< as the sheet that moves it farthest outward along the vertex normal; the most of a tint
  min,      ///< as the sheet that moves it farthest inward; the least
  add,      ///< the sum of all sheets
  average,  ///< their mean
};

/// The nodes of one symmetry instance of a stroke.
struct InstanceSheets {
  const LiveChart* chart;
  const NodeOutputs* outputs;  ///< [slot]
  /// [slot] where the stroke's width varies and instances are blended; else empty.
  std::span<const float> half_width = {};
  std::span<const float> dab_t = {};  ///< [slot] first coordinate within the dab; empty without dabs
};

/// How sheets become one. Where instances meet, their sheets are blended like those of one stroke; but of
/// `latest` each instance has its own, and the mean of these counts, the nearer its stroke the more: so that
/// what is symmetric stays so, without a step where the region of one begins.
struct BlendOptions {
  Overlap overlap = Overlap::latest;
  double radius = 1;                                       ///< of the stroke, object units
  double limit = std::numeric_limits<double>::infinity();  ///< vertices go no farther, object units
};

/// Where vertices go: [i] of `places` is for vertices[i], back to its base when it has no node. A vertex with
/// one node goes where displaced() puts it, bit for bit. Throws ContractError naming brush and (t, d) where
/// that is beyond the range of floats.
void blend_sheets(const Surface& surface, std::span<const InstanceSheets> instances,
                  std::span<const Index> vertices, const BlendOptions& options, std::string_view brush,
                  std::span<Vec3f> places);

/// The same for colours and masks: [i] of `tints` is for vertices[i], its paint's where it has no node.
void blend_tints(const Paint& paint, std::span<const InstanceSheets> instances,
                 std::span<const Index> vertices, const BlendOptions& options, std::span<Tint> tints);

}  // namespace burin
