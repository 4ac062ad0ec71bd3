#pragma once
#include <burin/deform/blend.h>
#include <burin/math/elementary.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace burin {

/// One node of a vertex.
struct SheetNode {
  const InstanceSheets* of;
  Index slot;

  const Chart& chart() const { return of->chart->nodes(); }
  const Vec3f& displacement() const { return of->outputs->displacement[slot]; }
  const Tint& tint() const { return of->outputs->tint[slot]; }
};

/// All nodes of a vertex, in all instances of a stroke.
class VertexSheets {
 public:
  VertexSheets(std::span<const InstanceSheets> instances, Index vertex)
      : instances_(instances), vertex_(vertex) {
    for_each([this](const SheetNode& node) {
      if (count_++ == 0) first_ = node;
    });
  }

  std::size_t count() const { return count_; }

  /// Of at least one.
  const SheetNode& first() const { return first_; }

  /// Instance by instance, by rising t.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (const InstanceSheets& instance : instances_)
      for (Index slot = instance.chart->first(vertex_); slot != no_index; slot = instance.chart->next(slot))
        visit(SheetNode{&instance, slot});
  }

  /// The last node of each instance that has one.
  template <class Visit>
  void for_each_latest(const Visit& visit) const {
    for (const InstanceSheets& instance : instances_) {
      SheetNode last{&instance, no_index};
      for (Index slot = instance.chart->first(vertex_); slot != no_index; slot = instance.chart->next(slot))
        last.slot = slot;
      if (last.slot != no_index) visit(last);
    }
  }

  /// visit(node, weight) for the last node of each instance; the weights add up to 1.
  template <class Visit>
  void for_each_weighed(double radius, const Visit& visit) const {
    double sum = 0;
    for_each_latest([&](const SheetNode& node) { sum += nearness(node, radius); });
    for_each_latest([&](const SheetNode& node) { visit(node, nearness(node, radius) / sum); });
  }

 private:
  /// Falls from 1 on the stroke, or in the middle of a dab, to next to nothing at its rim, level there.
  static double nearness(const SheetNode& node, double radius) {
    const Chart& chart = node.chart();
    const double reach = node.of->half_width.empty() ? radius : node.of->half_width[node.slot];
    const double distance = math::hypot(along(node), double{chart.d[node.slot]});
    const double inside = std::max(1 - distance / reach, 0.0);
    return inside * inside + 1e-12;
  }

  /// How far a node lies beyond an end, or from the middle of its dab.
  static double along(const SheetNode& node) {
    if (!node.of->dab_t.empty()) return node.of->dab_t[node.slot];
    const Chart& chart = node.chart();
    const double t = chart.t[node.slot];
    return chart.closed ? 0 : std::max({-t, t - chart.length, 0.0});
  }

  std::span<const InstanceSheets> instances_;
  Index vertex_;
  std::size_t count_ = 0;
  SheetNode first_{};
};

}  // namespace burin
