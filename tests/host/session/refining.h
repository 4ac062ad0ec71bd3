#pragma once
#include "../../refine/refined.h"
#include "../sessions.h"

#include <cstdint>
#include <vector>

namespace burin::test {

inline constexpr double radius = 0.12;

inline StrokeSettings refining(double edge) {
  StrokeSettings made = settings("org.burin.groove", radius);
  made.refining = {.kind = Refining::Kind::edge, .edge = edge};
  return made;
}

inline StrokeSettings refining_if_coarse() {
  StrokeSettings made = settings("org.burin.groove", radius);
  made.refining.kind = Refining::Kind::automatic;
  return made;
}

inline void draw_along(Session& session, const StrokeSettings& settings, const std::vector<Vec3d>& path) {
  session.begin_stroke(settings, path);
  double time = 0;
  for (const Vec3d& place : path)
    ASSERT_EQ(session.add_sample(place, time += 0.01, {}).outcome, StrokeEvent::Outcome::drawn);
  session.end_stroke();
}

inline Session box_session() { return Session(make_surface(box({2, 1, 1})), brushes()); }

/// From the top of the box over its edge.
inline std::vector<Vec3d> over_the_edge() {
  std::vector<Vec3d> path = straight({1.2, 0.4, 1}, {2, 0.5, 1});
  for (const Vec3d& place : straight({2, 0.5, 1}, {2, 0.6, 0.3})) path.push_back(place);
  path.erase(path.begin() + 41);
  return path;
}

/// All that a session has of its surface.
struct Everything {
  explicit Everything(const Session& session)
      : snapshot(session),
        triangles(session.surface().triangles),
        source(session.surface().source_vertex),
        curvature(session.surface().gauss_curvature),
        colour(session.paint().colour),
        hash(session.result_hash()) {}
  bool operator==(const Everything&) const = default;

  Snapshot snapshot;
  std::vector<Triangle> triangles;
  std::vector<Index> source;
  std::vector<float> curvature;
  std::vector<Vec4f> colour;
  std::uint64_t hash;
};

}  // namespace burin::test
