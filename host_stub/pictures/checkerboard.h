#pragma once
#include <burin/chart/chart.h>
#include <burin/surface/surface.h>
#include <burin/surface/surface_point.h>

#include <cstdint>
#include <vector>

namespace burin {

/// Colours a surface by stroke charts: squares of a quarter of the radius in (t, d), warm on the left
/// (d > 0) and cool on the right, clay where no chart reaches. An even number of squares goes around a closed
/// stroke. On top is the last chart, and of a stroke that overlaps itself the sheet of the highest t.
/// The surface must outlive it. Holds 4 bytes a vertex and 32 for each node of the charts.
class Checkerboard {
 public:
  explicit Checkerboard(const Surface& surface);

  void add(const Chart& chart, double radius);

  /// Linear RGB. Any thread, concurrent, between two calls of add.
  Vec3f operator()(const SurfacePoint& point) const;

 private:
  struct Scale {
    double squares_t, squares_d;  ///< in an object unit
    double length;                ///< of a closed stroke, object units; 0: open
  };
  struct Node {
    double t;
    float d;
    std::uint32_t chart;
    Index below;  ///< the vertex's next node, of a lower t or an earlier chart
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
  std::vector<Index> first_;  ///< [vertex] of nodes_, or no_index
  std::vector<Node> nodes_;
  std::vector<Scale> scales_;  ///< [chart]
};

/// Linear RGB of the square that holds (t, d), both in squares.
Vec3f checker_colour(double t, double d);

}  // namespace burin
