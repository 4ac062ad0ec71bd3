// Compares charts of hand-drawn strokes on real scans, with follow = 1, with exact geodesics of the
// polyhedron: every vertex near the stroke has a node, and the least distance among its nodes is its
// distance from the curve.
#include <burin/chart/stroke_chart_builder.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/triangulate.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <queue>
#include <random>
#include <utility>

#include "support/drawn_strokes.h"
#include "support/gentle_stroke.h"
#include "support/oracles/polyhedral_distance.h"
#include "support/oracles/region.h"
#include "support/shared_data.h"
#include "support/told_distances.h"
#include "support/viewed_stroke.h"

namespace burin {
namespace {

/// Vertices of which nothing is asked at the rim, where half an edge decides: share of the radius.
constexpr double asked = 0.97;

/// The range of radii, in edges.
constexpr double least_radius = 8, most_radius = 25;

constexpr int strokes_a_kind = 8, vertices_a_stroke = 40;

struct Tally {
  test::ToldErrors beside, beyond;  ///< the stroke; its ends, where these are what is nearest
  /// All vertices to which edges lead within the radius, and the holes among them.
  std::size_t reached = 0, holes_beside = 0, holes_beyond = 0;

  void add(const Tally& other) {
    beside.add(other.beside);
    beyond.add(other.beyond);
    reached += other.reached;
    holes_beside += other.holes_beside;
    holes_beyond += other.holes_beyond;
  }
};

std::ostream& operator<<(std::ostream& out, const Tally& tally) {
  return out << "beside " << tally.beside << "; beyond the ends " << tally.beyond << "; of all "
             << tally.reached << " that edges lead to holes: " << tally.holes_beside << " and "
             << tally.holes_beyond;
}

/// The curve's points and those half way between two.
std::vector<SurfacePoint> refined(const Picker& picker, const SurfaceCurve& curve, double radius) {
  std::vector<SurfacePoint> points;
  for (const CurvePoint& point : curve.points) {
    if (!points.empty()) {
      const Vec3f middle = (points.back().position + point.at.position) / 2;
      if (const auto at = picker.closest(middle, static_cast<float>(radius))) points.push_back(*at);
    }
    points.push_back(point.at);
  }
  return points;
}

/// The lengths of the shortest ways from the points to vertices along edges, up to `most`, object units:
/// never less than the distance.
std::map<Index, double> ways_along_edges(const Surface& surface, const std::vector<SurfacePoint>& points,
                                         double most) {
  using Way = std::pair<double, Index>;
  std::priority_queue<Way, std::vector<Way>, std::greater<>> queue;
  std::map<Index, double> least;
  const auto relax = [&](Index vertex, const Vec3f& from, double before) {
    const double way = before + (surface.positions[vertex] - from).cast<double>().norm();
    if (way > most) return;
    const auto [entry, is_new] = least.try_emplace(vertex, way);
    if (!is_new && entry->second <= way) return;
    entry->second = way;
    queue.emplace(way, vertex);
  };
  for (const SurfacePoint& point : points)
    for (const Index corner : point.corners) relax(corner, point.position, 0);
  while (!queue.empty()) {
    const auto [way, vertex] = queue.top();
    queue.pop();
    if (least[vertex] != way) continue;
    for (const Index next : surface.neighbours[vertex]) relax(next, surface.positions[vertex], way);
  }
  return least;
}

/// A chart and what its vertices are held against.
class Truth {
 public:
  Truth(const Surface& surface, const Picker& picker, const SurfaceCurve& curve, const Chart& chart,
        double radius)
      : surface_(surface),
        radius_(radius),
        points_(refined(picker, curve, radius)),
        region_(test::region_around(surface, points_, 1.3 * radius)),
        distance_(surface, region_, points_),
        told_(test::told_distances(chart)) {
    for (const Index vertex : region_.vertices)
      if (surface.incident[vertex].size() != surface.neighbours[vertex].size()) border_.push_back(vertex);
  }

  bool is_known() const { return distance_.is_known(); }

  Tally compare(std::mt19937& random) {
    Tally tally;
    std::vector<Index> near;
    std::ranges::copy_if(region_.vertices, std::back_inserter(near), [this](Index v) { return is_near(v); });
    for (int i = 0; i < vertices_a_stroke; ++i) compare(near[random() % near.size()], tally);
    for (const auto& [vertex, way] : ways_along_edges(surface_, points_, asked * radius_)) {
      if (behind_border(vertex, way)) continue;
      ++tally.reached;
      if (!told_.contains(vertex)) ++(nearest(vertex).at_end ? tally.holes_beyond : tally.holes_beside);
    }
    return tally;
  }

 private:
  double straight(Index vertex, const Vec3f& to) const {
    return (surface_.positions[vertex] - to).cast<double>().norm();
  }
  bool is_near(Index vertex) const {
    return std::ranges::any_of(points_, [&](const SurfacePoint& point) {
      return straight(vertex, point.position) <= asked * radius_;
    });
  }
  /// Whether a way of this length may touch where the surface ends.
  bool behind_border(Index vertex, double way) const {
    return std::ranges::any_of(
        border_, [&](Index other) { return straight(vertex, surface_.positions[other]) < way; });
  }

  struct Nearest {
    double distance;
    bool at_end;  ///< of the stroke
  };
  Nearest nearest(Index vertex) {
    const auto [distance, at] = distance_.from(vertex, asked * radius_);
    return {distance, at == 0 || at == static_cast<double>(points_.size() - 1)};
  }

  void compare(Index vertex, Tally& tally) {
    const auto [exact, at_end] = nearest(vertex);
    if (exact > asked * radius_ || behind_border(vertex, exact)) return;
    (at_end ? tally.beyond : tally.beside).add(told_, vertex, exact, radius_);
  }

  const Surface& surface_;
  double radius_;
  std::vector<SurfacePoint> points_;
  test::Region region_;
  test::PolylineDistance distance_;
  std::map<Index, double> told_;
  std::vector<Index> border_;
};

/// The tolerances for the charts of a scan.
struct Scan {
  const char* file;
  double off_beside, off_beyond;      ///< sampled vertices off by > 5 %, of a thousand
  double holes_beside, holes_beyond;  ///< of a thousand that edges lead to
};
std::ostream& operator<<(std::ostream& out, const Scan& scan) { return out << scan.file; }

Tally draw_all(const Surface& surface, std::uint32_t seed) {
  const Picker picker(surface);
  StrokeChartBuilder builder(surface);
  const double edge = test::mean_edge(surface);
  std::mt19937 random(seed);
  Tally all;
  int left_out = 0;
  for (const std::string_view kind : test::drawn_kinds()) {
    Tally of_kind;
    for (int stroke = 0; stroke < strokes_a_kind;) {
      const double share = static_cast<double>(random()) / 4294967296.;
      const double radius = edge * least_radius * std::pow(most_radius / least_radius, share);
      const auto samples = test::drawn_stroke(kind, random);
      const auto curve = test::viewed_stroke(surface, picker, samples, radius, random);
      if (curve) {
        Truth truth(surface, picker, *curve, builder.chart(*curve, {.radius = radius}), radius);
        if (truth.is_known()) {
          of_kind.add(truth.compare(random));
          ++stroke;
          continue;
        }
      }
      if (++left_out > 1000) throw std::runtime_error("hardly a stroke stays on the surface");
    }
    std::cout << "  " << kind << ": " << of_kind << "\n";
    all.add(of_kind);
  }
  std::cout << "seed " << seed << ": " << all << "; " << left_out << " strokes left out\n";
  return all;
}

class DrawnOnScans : public testing::TestWithParam<Scan> {};

TEST_P(DrawnOnScans, HaveExactDistances) {
  BURIN_SHARED_DATA_OR_SKIP(file, std::string("meshes/") + GetParam().file);
  const Tally tally = draw_all(make_surface(triangulate(read_mesh(file))), 43);
  const auto of_a_thousand = [](std::size_t some, std::size_t all) {
    return 1000 * static_cast<double>(some) / static_cast<double>(all);
  };
  const auto& [beside, beyond, reached, holes_beside, holes_beyond] = tally;
  EXPECT_GT(beside.vertices, 2500U);
  EXPECT_GT(beyond.vertices, 1000U);
  EXPECT_EQ(beside.holes, 0U);
  EXPECT_LE(of_a_thousand(beside.off_5, beside.vertices), GetParam().off_beside);
  EXPECT_LE(of_a_thousand(beyond.off_5, beyond.vertices), GetParam().off_beyond);
  EXPECT_LE(of_a_thousand(holes_beside, reached), GetParam().holes_beside);
  EXPECT_LE(of_a_thousand(holes_beyond, reached), GetParam().holes_beyond);
}

// What is aimed at is 1 off of a thousand and no holes, which is reached but for three things. Nefertiti, a
// scan of few triangles, folds within an edge under some strokes, and there charts tell distances that are
// too short. Five vertices of the bunny that lie at the rim of caps have no node. The dragon has edges of no
// length, and some vertices at these no node.
INSTANTIATE_TEST_SUITE_P(Shared, DrawnOnScans,
                         testing::Values(Scan{"stanford-bunny.obj", 1, 1, 0, 0.03},
                                         Scan{"nefertiti-lowres.obj", 2, 4, 0, 0},
                                         Scan{"dragon_vrip.ply", 1, 1, 0.05, 0.01}),
                         [](const auto& scan) { return test::test_name_of(scan.param.file); });

}  // namespace
}  // namespace burin
