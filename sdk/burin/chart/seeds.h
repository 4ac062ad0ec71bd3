#pragma once
#include <burin/base/vector.h>
#include <burin/chart/chart_frame.h>
#include <burin/chart/chart_nodes.h>
#include <burin/chart/stroke_samples.h>
#include <burin/stroke/geodesic_curvature.h>
#include <burin/stroke/surface_curve.h>
#include <burin/surface/surface.h>

#include <cstddef>
#include <vector>

namespace burin {

/// A node beside the stroke with the coordinates of its own foot point on a stroke segment.
struct Seed {
  Index node = no_index;
  float distance = 0;  ///< to the foot, object units
  ChartFrame frame;    ///< t at the foot, beyond the ends along the end's tangent; e1 transported from it
};

/// The nearest point of one segment of the stroke to some vertex.
struct Foot {
  std::size_t segment = 0;
  float s = 0;  ///< 0..1 along the segment
  Vec3f position = Vec3f::Zero();
  float distance = 0;
};

/// Finds where the front starts. The surface must outlive it.
class SeedFinder {
 public:
  explicit SeedFinder(const Surface& surface) : surface_(&surface) {}

  /// For every visit of the corners of the curve's points, and of their one-ring, the nearest foot on the
  /// segments nearby; one seed a node, in order of first appearance.
  std::vector<Seed> find(const SurfaceCurve& curve, const GeodesicCurvature& curvature,
                         const StrokeSamples& samples, ChartNodes& nodes);

 private:
  void offer(const SurfaceCurve& curve, const StrokeSamples& samples, ChartNodes& nodes, Index vertex,
             std::size_t segment);

  const Surface* surface_;
  std::vector<Index> found_;  ///< nodes
  std::vector<Foot> feet_;    ///< [i] the best so far of found_[i]
  std::vector<Index> entry_;  ///< [node] in found_, or no_index
};

}  // namespace burin
