// Charts of strokes as people draw them on real scans, every bump of which they follow, against exact
// geodesics of the polyhedron: vertices near the stroke have a node, and the least distance among the nodes of
// one is its distance to the curve.
#include <burin/chart/stroke_chart.h>
#include <burin/surface/closest_point.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/normals.h>
#include <burin/surface/triangulate.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <queue>
#include <random>

#include "support/drawn_strokes.h"
#include "support/gentle_stroke.h"
#include "support/polyhedral_distance.h"
#include "support/shared_data.h"
#include "support/told_distances.h"

namespace burin {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Vertices of which nothing is asked at the rim, where half an edge decides: share of the radius.
constexpr double asked = 0.97;

struct Tally {
  std::size_t strokes = 0, vertices = 0, holes = 0, off_2 = 0, off_5 = 0, off_10 = 0;  ///< off by so many % of r
  std::size_t reached = 0, unreached = 0;  ///< vertices to which edges lead, of these without a node
  double worst = 0;

  void add(const Tally& other) {
    strokes += other.strokes;
    vertices += other.vertices;
    holes += other.holes;
    off_2 += other.off_2;
    off_5 += other.off_5;
    off_10 += other.off_10;
    reached += other.reached;
    unreached += other.unreached;
    worst = std::max(worst, other.worst);
  }
};

std::ostream& operator<<(std::ostream& out, const Tally& tally) {
  return out << tally.strokes << " strokes, " << tally.vertices << " vertices: " << tally.holes << " holes, "
             << tally.off_2 << " off by > 2 %, " << tally.off_5 << " off by > 5 %, " << tally.off_10
             << " by > 10 %, worst " << 100 * tally.worst << " %; of " << tally.reached
             << " vertices that edges lead to " << tally.unreached << " holes";
}

double uniform(std::mt19937& random) { return static_cast<double>(random()) / 4294967296.; }

/// The surface curve of a stroke that is drawn in a plane three radii above a random vertex and meets the surface
/// along the normal there. A pen that leaves what is seen from there, or jumps, ends it.
struct Drawn {
  SurfaceCurve curve;
  double share = 0;  ///< of the samples
};

Drawn drawn_onto(const Surface& surface, const Picker& picker, const std::vector<Vec2d>& in_radii, double radius,
                 std::mt19937& random) {
  const Index middle = static_cast<Index>(random() % surface.vertex_count());
  const Vec3f n = surface.normals[middle], right = n.unitOrthogonal(), up = n.cross(right);
  CurveTracer tracer(surface, picker, radius);
  std::size_t count = 0;
  for (const Vec2d& sample : in_radii) {
    const Vec2f at = (radius * sample).cast<float>();
    const Vec3f above =
        surface.positions[middle] + at.x() * right + at.y() * up + static_cast<float>(3 * radius) * n;
    const auto hit = picker.pick({above, -n});
    if (!hit || normal_at(surface, *hit).dot(n) <= 0 || (count > 0 && !tracer.connects(*hit))) break;
    tracer.add(*hit, static_cast<double>(count++) / 240, {});
  }
  return {tracer.curve(), static_cast<double>(count) / static_cast<double>(in_radii.size())};
}

/// Points of the curve and between them.
std::vector<SurfacePoint> refined(const Picker& picker, const SurfaceCurve& curve, int parts, double radius) {
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    points.push_back(curve.points[i].at);
    if (i + 1 == curve.points.size()) break;
    const Vec3f a = points.back().position, b = curve.points[i + 1].at.position;
    for (int part = 1; part < parts; ++part) {
      const float share = static_cast<float>(part) / static_cast<float>(parts);
      if (const auto at = picker.closest(a + share * (b - a), static_cast<float>(radius))) points.push_back(*at);
    }
  }
  return points;
}

class Nearness {
 public:
  explicit Nearness(const std::vector<SurfacePoint>& points) : points_(points) {}
  bool within(const Vec3f& x, double reach) const {
    const float limit = static_cast<float>(reach * reach);
    return std::ranges::any_of(points_,
                               [&](const SurfacePoint& point) { return (point.position - x).squaredNorm() <= limit; });
  }
  double distance(const Vec3f& x) const {
    float least = std::numeric_limits<float>::max();
    for (const SurfacePoint& point : points_) least = std::min(least, (point.position - x).squaredNorm());
    return std::sqrt(static_cast<double>(least));
  }

 private:
  const std::vector<SurfacePoint>& points_;
};

test::Region region_around(const Surface& surface, const std::vector<SurfacePoint>& points, double reach) {
  const Nearness near(points);
  std::vector<bool> seen(surface.vertex_count());
  std::vector<Index> found;
  const auto visit = [&](Index vertex) {
    if (seen[vertex]) return;
    seen[vertex] = true;
    if (near.within(surface.positions[vertex], reach)) found.push_back(vertex);
  };
  for (const SurfacePoint& point : points) std::ranges::for_each(point.corners, visit);
  for (std::size_t i = 0; i < found.size(); ++i) std::ranges::for_each(surface.neighbours[found[i]], visit);
  std::vector<Index> triangles;
  for (const Index vertex : found)
    triangles.insert(triangles.end(), surface.incident[vertex].begin(), surface.incident[vertex].end());
  return test::make_region(surface, std::move(triangles));
}

bool on_border(const Surface& surface, Index vertex) {
  return surface.incident[vertex].size() != surface.neighbours[vertex].size();
}

/// Lengths of ways from the points along edges.
std::map<Index, double> ways(const Surface& surface, const std::vector<SurfacePoint>& points, double most) {
  std::map<Index, double> least;
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto relax = [&](Index vertex, double way) {
    if (way > most) return;
    const auto [entry, is_new] = least.try_emplace(vertex, way);
    if (!is_new && entry->second <= way) return;
    entry->second = way;
    queue.emplace(way, vertex);
  };
  for (const SurfacePoint& point : points)
    for (const Index corner : point.corners)
      relax(corner, (surface.positions[corner] - point.position).cast<double>().norm());
  while (!queue.empty()) {
    const auto [way, vertex] = queue.top();
    queue.pop();
    if (least[vertex] != way) continue;
    for (const Index next : surface.neighbours[vertex])
      relax(next, way + (surface.positions[next] - surface.positions[vertex]).cast<double>().norm());
  }
  return least;
}

int env(const char* name, int fallback) { const char* v = std::getenv(name); return v ? std::atoi(v) : fallback; }

void describe(const Surface& surface, const std::vector<SurfacePoint>& points, Index vertex, double told,
              double exact, double radius, double edge, std::string_view kind, int stroke) {
  double least = infinite;
  Vec3f n = Vec3f::Zero();
  for (const SurfacePoint& p : points) {
    const double far = (p.position - surface.positions[vertex]).cast<double>().norm();
    if (far < least) { least = far; n = normal_at(surface, p); }
  }
  // sharpest fold around
  double sharpest = 1;
  for (const Index t : surface.incident[vertex]) for (const Index u : surface.incident[vertex]) {
    const auto normal = [&](Index w) { const auto& [a, b, c] = surface.triangles[w];
      return Vec3f((surface.positions[b] - surface.positions[a]).cross(surface.positions[c] - surface.positions[a]).normalized()); };
    sharpest = std::min(sharpest, static_cast<double>(normal(t).dot(normal(u))));
  }
  std::cout << "    BAD " << kind << " stroke " << stroke << " r " << radius / edge << " edges, vertex "
            << surface.source_vertex[vertex] << " at " << surface.positions[vertex].transpose() << " told "
            << told / radius << " exact " << exact / radius << " straight " << least / radius << " n.n "
            << n.dot(surface.normals[vertex]) << " sharpest here " << sharpest << "\n";
}

struct Scan {
  const char* file;
};
std::ostream& operator<<(std::ostream& out, const Scan& scan) { return out << scan.file; }

class DrawnOnScans : public testing::TestWithParam<Scan> {};

TEST_P(DrawnOnScans, HaveExactDistances) {
  BURIN_SHARED_DATA_OR_SKIP(file, std::string("meshes/") + GetParam().file);
  const Surface surface = make_surface(triangulate(read_mesh(file)));
  const Picker picker(surface);
  StrokeCharter charter(surface);
  const double edge = test::mean_edge(surface);
  std::mt19937 random(static_cast<std::uint32_t>(env("SEED", 41)));
  const int strokes_a_kind = env("STROKES", 8), vertices_a_stroke = env("VERTICES", 25), parts = env("PARTS", 2);
  Tally all;
  std::size_t thrown = 0, unknown = 0;
  double chart_time = 0, region_time = 0, exact_time = 0, ways_time = 0;
  const auto now = [] { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); };
  for (const std::string_view kind : test::drawn_kinds()) {
    Tally of_kind;
    for (int stroke = 0; stroke < strokes_a_kind;) {
      const double radius = edge * 8 * std::pow(25. / 8, uniform(random));
      const Drawn drawn = drawn_onto(surface, picker, test::drawn_stroke(kind, random), radius, random);
      if (drawn.share < 0.5) { ++thrown; continue; }
      double begin = now();
      const Chart chart = charter.chart(drawn.curve, {.radius = radius});
      chart_time += now() - begin; begin = now();
      const auto points = refined(picker, drawn.curve, parts, radius);
      const test::Region region = region_around(surface, points, 1.3 * radius);
      test::PolylineDistance distance(surface, region, points);
      region_time += now() - begin;
      if (!distance.is_known()) { ++unknown; continue; }
      const int number = stroke++;
      const std::map<Index, double> told = test::told_distances(chart);
      const Nearness near(points);
      std::vector<Index> candidates, border;
      for (const Index vertex : region.vertices) {
        if (near.within(surface.positions[vertex], asked * radius)) candidates.push_back(vertex);
        if (on_border(surface, vertex)) border.push_back(vertex);
      }
      const auto border_distance = [&](Index vertex) {
        double least = infinite;
        for (const Index other : border)
          least = std::min(least, (surface.positions[other] - surface.positions[vertex]).cast<double>().norm());
        return least;
      };
      Tally tally;
      tally.strokes = 1;
      begin = now();
      for (const auto& [vertex, way] : ways(surface, points, asked * radius)) {
        if (border_distance(vertex) < way) continue;
        ++tally.reached;
        if (told.contains(vertex)) continue;
        ++tally.unreached;
        if (tally.unreached <= 3) describe(surface, points, vertex, -1, way, radius, edge, kind, number);
      }
      ways_time += now() - begin; begin = now();
      for (int i = 0; i < vertices_a_stroke; ++i) {
        const Index vertex = candidates[random() % candidates.size()];
        const double exact = distance.from(vertex, asked * radius);
        if (exact > asked * radius || border_distance(vertex) < exact) continue;
        ++tally.vertices;
        const auto found = told.find(vertex);
        if (found == told.end()) {
          ++tally.holes;
          describe(surface, points, vertex, -1, exact, radius, edge, kind, number);
          continue;
        }
        const double error = std::abs(found->second - exact) / radius;
        tally.off_2 += error > 0.02;
        tally.off_5 += error > 0.05;
        tally.off_10 += error > 0.1;
        if (error > 0.05) describe(surface, points, vertex, found->second, exact, radius, edge, kind, number);
        tally.worst = std::max(tally.worst, error);
      }
      exact_time += now() - begin;
      of_kind.add(tally);
    }
    std::cout << "  " << kind << ": " << of_kind << std::endl;
    all.add(of_kind);
  }
  std::cout << GetParam().file << " vertices " << surface.vertex_count() << ": " << all << "; thrown " << thrown
            << ", non-manifold " << unknown << "; s: chart " << chart_time << " region " << region_time << " ways "
            << ways_time << " exact " << exact_time << std::endl;
}

INSTANTIATE_TEST_SUITE_P(Shared, DrawnOnScans,
                         testing::Values(Scan{"stanford-bunny.obj"}, Scan{"nefertiti-lowres.obj"},
                                         Scan{"dragon_vrip.ply"}),
                         [](const auto& scan) {
                           std::string name = scan.param.file;
                           name = name.substr(0, name.find('.'));
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace burin
