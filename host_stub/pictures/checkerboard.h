#pragma once
#include <burin/base/vector.h>
#include <burin/chart/chart.h>
#include <burin/surface/surface.h>
#include <burin/surface/surface_point.h>

#include <cstdint>
#include <vector>

namespace burin {

/// Colours a surface by stroke charts: squares of a quarter of the radius in (t, d), warm on the left (d > 0)
/// and cool on the right; clay outside of the charts. A closed stroke has an even number of squares along its
/// length. The last chart is on top, and in a stroke that overlaps itself the sheet with the highest t. The
/// surface must outlive the object. Uses 4 bytes per vertex and 32 per node.
class Checkerboard {
 public:
  explicit Checkerboard(const Surface& surface);

  /// Adds a chart of a stroke with this radius, object units.
  void add(const Chart& chart, double radius);

  /// The colour at a point, linear RGB. May be called from several threads at once, but not during add().
  Vec3f operator()(const SurfacePoint& point) const;

 private:
  struct Scale {
    double squares_t, squares_d;  ///< squares per object unit
    double length;                ///< length of a closed stroke, object units; 0 for an open one
  };
  struct Node {
    double t;
    float d;
    std::uint32_t chart;
    Index below;  ///< the vertex's next node, with a lower t or of an earlier chart
  };
  /// Nodes of a triangle's corners that lie on one sheet, t unwrapped.
  struct SheetTriangle {
    const Node* corners[3];
    double t[3];
  };
  bool find_sheet(const SurfacePoint& point, SheetTriangle& sheet) const;
  bool on_sheet_of(const SheetTriangle& sheet, int corner, double edge) const;
  bool complete(const SurfacePoint& point, double edge, int corner, SheetTriangle& sheet) const;
  Vec3f colour(const Node& node, double t, double d) const;
  const Node* top(Index vertex) const {
    return first_[vertex] == no_index ? nullptr : &nodes_[first_[vertex]];
  }
  const Node* below(const Node& node) const { return node.below == no_index ? nullptr : &nodes_[node.below]; }

  const Surface* surface_;
  std::vector<Index> first_;  ///< [vertex] index of its topmost node in nodes_, or no_index
  std::vector<Node> nodes_;
  std::vector<Scale> scales_;  ///< [chart]
};

/// The colour, linear RGB, of the square that holds (t, d), which are in units of squares.
Vec3f checker_colour(double t, double d);

}  // namespace burin
