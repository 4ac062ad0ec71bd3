#pragma once
#include <burin/chart/chart.h>
#include <burin/surface/surface.h>
#include <burin/surface/surface_point.h>

#include <cstdint>
#include <vector>

namespace burin {

/// Colours a surface by stroke charts: squares of a quarter of the radius in (t, d), warm on the left
/// (d > 0) and cool on the right, clay where no chart reaches. Where charts overlap the last one shows.
/// Holds 12 bytes a vertex.
class Checkerboard {
 public:
  explicit Checkerboard(const Surface& surface);

  void add(const Chart& chart, double radius);

  /// Linear RGB. Any thread, concurrent, between two calls of add.
  Vec3f operator()(const SurfacePoint& point) const;

 private:
  struct Node {
    float t = 0, d = 0;       // in squares
    std::uint32_t chart = 0;  // 0: none
  };

  std::vector<Node> nodes_;
  std::uint32_t charts_ = 0;
};

/// Linear RGB of the square that holds (t, d), both in squares.
Vec3f checker_colour(float t, float d);

}  // namespace burin
