// Makes the sheet of a node from the chart and the outputs of the brush, in O(1).
#include <burin/chart/path/closed_length.h>
#include <burin/deform/blend/sheet.h>
#include <burin/math/elementary.h>

namespace burin {
namespace {

/// The distance of a node along the stroke beyond an end of the stroke, or from the middle of its dab.
double along(const InstanceSheets& instance, Index slot) {
  if (!instance.dab_t.empty()) return instance.dab_t[slot];
  const Chart& chart = instance.chart->nodes();
  return beyond_ends(chart.t[slot], chart.length, chart.closed);
}

}  // namespace

Sheet InstanceSheets::sheet(Index slot, double radius, std::uint32_t piece, std::uint32_t image) const {
  const Chart& nodes = chart->nodes();
  const double reach = half_width.empty() ? radius : half_width[slot];
  const double distance = math::hypot(along(*this, slot), double{nodes.d[slot]});
  return {.e1 = nodes.e1[slot],
          .normal = nodes.normal[slot],
          .displacement = outputs->displacement[slot],
          .tint = outputs->tint.empty() ? Tint::Zero() : outputs->tint[slot],
          .inside = distance < reach ? 1 - distance / reach : 0,
          .t = nodes.t[slot],
          .piece = piece,
          .image = image};
}

}  // namespace burin
