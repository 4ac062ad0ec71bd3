#pragma once
#include <burin/feature/edge_lines.h>
#include <burin/feature/snapped_curve.h>
#include <burin/surface/surface.h>

#include <map>
#include <span>
#include <vector>

namespace burin {

/// What a walk along edges leaves out, object units.
struct WalkLimits {
  double least_step = 0;    ///< points within edges that are nearer to a point before or a vertex after them
  double longest_spur = 0;  ///< ways up to this length that lead back to the vertex where they began
};

/// Ways along the edges of lines, from vertex to vertex. The surface must outlive the object.
class EdgeWalk {
 public:
  EdgeWalk(const Surface& surface, std::span<const LineEdge> edges);

  /// Adds to a run of points on the edges the vertices that the lines pass on the way from each point to the
  /// next one, so that it keeps their corners. Nothing is added where the shortest way is more than four
  /// times as long as the straight one, which is another line. `period`: the length of a stroke that the run
  /// closes; 0 for open runs.
  SnappedRun with_vertices(const SnappedRun& run, double period, const WalkLimits& limits) const;

 private:
  std::vector<Index> way(const SurfacePoint& from, const SurfacePoint& to) const;
  SurfacePoint point_at(Index vertex) const;

  const Surface& surface_;
  std::map<Index, std::vector<Index>> neighbours_;  ///< along the lines
};

}  // namespace burin
