// Tests random strokes on meshes that are non-manifold, torn, folded, degenerate or made of slivers:
// charts stay finite and bounded, and a growing chart equals one that is computed at once.
#include <burin/chart/chart_lookup.h>
#include <burin/chart/joins/joins.h>
#include <burin/chart/stroke_chart_builder.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/triangulate.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "support/closed_curve.h"
#include "support/gentle_stroke.h"
#include "support/same_chart.h"
#include "support/shapes.h"
#include "support/shared_data.h"

namespace burin {
namespace {

using Random = std::mt19937;

/// Uniform in [0, 1), the same on every platform.
double uniform(Random& random) { return static_cast<double>(random()) / 4294967296.; }

bool one_in(Random& random, unsigned count) { return random() % count == 0; }

Vec3f random_vector(Random& random) {
  const double x = uniform(random), y = uniform(random), z = uniform(random);
  return (2 * Vec3d(x, y, z) - Vec3d::Ones()).cast<float>();
}

struct Place {
  Vec3f position;
  Vec3f normal;  ///< of the triangle, or anything where it has no area
};

Place random_place(const Surface& surface, Random& random) {
  const Triangle& c = surface.triangles[random() % surface.triangles.size()];
  const Vec3f &a = surface.positions[c[0]], &b = surface.positions[c[1]], &d = surface.positions[c[2]];
  const auto u = static_cast<float>(uniform(random) / 2), v = static_cast<float>(uniform(random) / 2);
  const Vec3f normal = (b - a).cross(d - a);
  return {(1 - u - v) * a + u * b + v * d, normal.norm() > 0 ? normal.normalized() : Vec3f::UnitZ()};
}

/// Samples of a wobbling walk, at times back the way it came, at times somewhere else altogether.
std::vector<Vec3f> walk(const Surface& surface, float size, Random& random) {
  const Place begin = random_place(surface, random);
  Vec3f heading = (random_place(surface, random).position - begin.position).normalized();
  std::vector<Vec3f> samples = {begin.position};
  for (auto more = random() % 14; more > 0; --more) {
    if (one_in(random, 8)) heading = -heading;
    const Vec3f ahead = samples.back() + size * (heading + 0.7F * random_vector(random));
    samples.push_back(one_in(random, 20) ? random_place(surface, random).position : ahead);
    if (one_in(random, 20)) samples.push_back(samples.back());
  }
  return samples;
}

/// Samples of a loop that winds around a random place, once or more, and crosses itself or not.
std::vector<Vec3f> loop(const Surface& surface, float size, Random& random) {
  const auto [centre, normal] = random_place(surface, random);
  const Vec3f u = normal.unitOrthogonal(), v = normal.cross(u);
  const auto turns = static_cast<double>(1 + random() % 2), waves = static_cast<double>(1 + random() % 3);
  const int count = 5 + static_cast<int>(random() % 16);
  std::vector<Vec3f> samples;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    samples.push_back(centre + size * static_cast<float>(std::cos(turns * angle)) * u +
                      size * static_cast<float>(std::sin(waves * angle)) * v);
  }
  return samples;
}

/// Widths that vary with the arc length: not at all, slowly, or from point to point.
class Widths {
 public:
  Widths(double knot_distance, Random& random)
      : kind_(static_cast<unsigned>(random() % 3)), knot_distance_(knot_distance) {
    for (float& knot : knots_) knot = static_cast<float>(0.02 + 0.98 * uniform(random));
  }
  float at(std::size_t point, double t) const {
    if (kind_ == 0) return 1;
    if (kind_ == 1) return knots_[point % knots_.size()];
    const double place = t / knot_distance_, from = std::floor(place);
    const auto knot = static_cast<std::size_t>(from) % knots_.size();
    const auto s = static_cast<float>(place - from);
    return (1 - s) * knots_[knot] + s * knots_[(knot + 1) % knots_.size()];
  }

 private:
  unsigned kind_;
  double knot_distance_;
  std::array<float, 37> knots_{};
};

/// The options of a stroke, and its curves while it is drawn; the last one is the whole stroke.
struct RandomStroke {
  ChartOptions options;
  std::vector<SurfaceCurve> stages;
  const SurfaceCurve& whole() const { return stages.back(); }
};

/// The stroke after each of the samples that it can reach; `closed`: then back to the first, if it can.
std::vector<SurfaceCurve> traced_stages(const Surface& surface, const Picker& picker, double radius,
                                        const std::vector<Vec3f>& samples, double reach, bool closed) {
  std::vector<SurfaceCurve> stages;
  CurveTracer tracer(surface, picker, radius);
  const auto add = [&](const SurfacePoint& at) {
    if (!tracer.connects(at)) return false;
    tracer.add(at, 0, {});
    stages.push_back(tracer.curve());
    return true;
  };
  for (const Vec3f& sample : samples) {
    if (const auto at = picker.closest(sample, static_cast<float>(reach))) add(*at);
  }
  const SurfacePoint begin = stages.front().points[0].at;
  const bool has_left = stages.back().points.back().at.position != begin.position;
  if (closed && has_left && add(begin)) test::close(stages.back());
  return stages;
}

/// A random stroke with a radius from a fifth of an edge to more than half of the mesh.
RandomStroke random_stroke(const Surface& surface, const Picker& picker, double edge, Random& random) {
  RandomStroke stroke;
  const double least = 0.2 * edge, radius = least * std::pow(0.7 * surface.scale / least, uniform(random));
  stroke.options = {radius, one_in(random, 2) ? Cap::butt : Cap::round, one_in(random, 2) ? 1 : 2};
  stroke.options.join = static_cast<Join>(random() % 4);
  const double size = std::min(radius * (0.1 + 4 * uniform(random)), surface.scale / 2);
  const bool closed = one_in(random, 3), round = closed || one_in(random, 2);
  const auto samples = round ? loop(surface, static_cast<float>(size), random)
                             : walk(surface, static_cast<float>(size), random);
  stroke.stages = traced_stages(surface, picker, radius, samples, 2 * size + edge, closed);
  const Widths widths(radius * (0.2 + uniform(random)), random);
  for (SurfaceCurve& stage : stroke.stages) {
    for (std::size_t i = 0; i < stage.points.size(); ++i) {
      stage.points[i].width = widths.at(i, stage.points[i].t);
    }
  }
  return stroke;
}

void expect_sound_curve(const SurfaceCurve& curve) {
  double before = 0;
  for (const CurvePoint& point : curve.points) {
    ASSERT_TRUE(point.at.position.allFinite() && std::isfinite(point.t) && point.t >= before);
    ASSERT_NEAR(point.normal.norm(), 1, 1e-4);
    ASSERT_NEAR(point.tangent.norm(), 1, 1e-4);
    ASSERT_TRUE(point.width > 0 && point.width <= 1);
    before = point.t;
  }
}

/// Upper bound of the stroke's half width at t: the widths in an eighth of the radius around it.
double widest_around(const SurfaceCurve& curve, const ChartOptions& options, double t) {
  const double reach = 1.001 * options.radius / 8;
  const auto& points = curve.points;
  double widest = 0;
  const auto look = [&](double from, double to) {
    auto begin = std::ranges::upper_bound(points, from, {}, &CurvePoint::t);
    auto end = std::ranges::lower_bound(points, to, {}, &CurvePoint::t);
    if (begin != points.begin()) --begin;
    if (end != points.end()) ++end;
    for (; begin != end; ++begin) widest = std::max(widest, static_cast<double>(begin->width));
    if (curve.closed && to >= points.back().t)
      widest = std::max(widest, static_cast<double>(points[0].width));
  };
  if (!curve.closed) t = std::clamp(t, 0., curve.length());
  look(t - reach, t + reach);
  if (curve.closed && t < reach) look(curve.length() + t - reach, curve.length());
  return widest * options.radius;
}

double distance_to_segment(const Vec3d& x, const Vec3d& a, const Vec3d& b) {
  const double square = (b - a).squaredNorm();
  const double s = square > 0 ? std::clamp((x - a).dot(b - a) / square, 0., 1.) : 0;
  return (x - a - s * (b - a)).norm();
}

/// Whether a segment of the curve is that near to x on the straight line. Looks around t first.
bool is_near(const SurfaceCurve& curve, double t, const Vec3f& x, double distance) {
  const auto after = std::ranges::upper_bound(curve.points, t, {}, &CurvePoint::t);
  const auto at_t = static_cast<std::size_t>(std::max(after - curve.points.begin(), std::ptrdiff_t{1}) - 1);
  for (std::size_t i = 0; i < curve.segment_count(); ++i) {
    const std::size_t segment = (at_t + i) % curve.segment_count();
    if (distance_to_segment(x.cast<double>(), curve.points[segment].at.position.cast<double>(),
                            curve.points[curve.next(segment)].at.position.cast<double>()) <= distance)
      return true;
  }
  return false;
}

double longest_edge_at(const Surface& surface, Index vertex) {
  float longest = 0;
  for (const Index other : surface.neighbours[vertex]) {
    longest = std::max(longest, (surface.positions[other] - surface.positions[vertex]).norm());
  }
  return longest;
}

void expect_sound_node(const Surface& surface, const RandomStroke& stroke, const Chart& chart,
                       std::size_t i) {
  const SurfaceCurve& curve = stroke.whole();
  const double t = chart.t[i], d = chart.d[i], length = curve.length();
  ASSERT_TRUE(std::isfinite(t) && std::isfinite(d));
  ASSERT_TRUE(std::isfinite(chart.stretch[i]) && chart.stretch[i] > 0) << chart.stretch[i];
  const double beyond = curve.closed ? 0 : std::max({-t, t - length, 0.});
  // Joins move t, and with it the width that was asked for where the node was placed.
  const bool moved = stroke.options.join != Join::round;
  ASSERT_LE(std::hypot(d, beyond),
            (moved ? stroke.options.radius : widest_around(curve, stroke.options, t)) * 1.000001)
      << "t " << t;
  ASSERT_TRUE(!curve.closed || (t >= 0 && (t < length || t == 0))) << t;
  ASSERT_TRUE(stroke.options.cap == Cap::round || beyond == 0) << t;
  const Vec3f& normal = surface.normals[chart.vertex[i]];
  ASSERT_NEAR(chart.e1[i].norm(), 1, 1e-4);
  ASSERT_NEAR(chart.e1[i].dot(normal), 0, 1e-3);
  // Miters of up to 120 degrees go as far as two radii from their corner.
  const double reach = stroke.options.join == Join::miter ? 2.1 : 1.3;
  ASSERT_TRUE(is_near(curve, t, surface.positions[chart.vertex[i]],
                      reach * stroke.options.radius + longest_edge_at(surface, chart.vertex[i])));
}

void expect_sheets_in_order(const Chart& chart) {
  for (std::size_t i = 0; i < chart.size(); ++i) {
    const bool same = i > 0 && chart.vertex[i - 1] == chart.vertex[i];
    ASSERT_TRUE(i == 0 || chart.vertex[i - 1] <= chart.vertex[i]);
    ASSERT_EQ(chart.sheet[i], same ? chart.sheet[i - 1] + 1 : 0);
    ASSERT_TRUE(!same || chart.t[i - 1] <= chart.t[i]);
  }
}

/// The chart of the whole, grown through some of the stages.
Chart grown(StrokeChartBuilder& builder, const RandomStroke& stroke, Random& random) {
  const std::size_t pieces = 1 + random() % 5;
  Chart chart;
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    const SurfaceCurve& curve =
        stroke.stages[piece + 1 < pieces ? random() % stroke.stages.size() : stroke.stages.size() - 1];
    chart = piece == 0 ? builder.chart(curve, stroke.options) : builder.extend(curve);
  }
  return chart;
}

/// Expects that the points found at the coordinates of some nodes have these coordinates.
void expect_sound_lookup(const Surface& surface, const Chart& chart, Random& random) {
  if (chart.size() == 0) return;
  const ChartLookup lookup(surface, chart);
  for (int i = 0; i < 20; ++i) {
    const std::size_t node = random() % chart.size();
    const auto place = lookup.find(chart.t[node], chart.d[node], chart.sheet[node]);
    if (!place) continue;
    ASSERT_TRUE(place->at.position.allFinite());
    ASSERT_NEAR(place->e1.norm(), 1, 1e-4);
    const double off = place->t - chart.t[node], scale = 1e-5 * (surface.scale + chart.length);
    ASSERT_NEAR(chart.closed ? std::remainder(off, chart.length) : off, 0, scale);
    ASSERT_NEAR(place->d, chart.d[node], scale);
  }
}

/// Whether two sheets of a vertex near the stroke run across each other.
bool crosses_itself(const Chart& chart, double radius) {
  for (std::size_t i = 1; i < chart.size(); ++i) {
    const bool near = std::abs(chart.d[i - 1]) < 0.5 * radius && std::abs(chart.d[i]) < 0.5 * radius;
    if (chart.sheet[i] > 0 && near && std::abs(chart.e1[i - 1].dot(chart.e1[i])) < 0.8F) return true;
  }
  return false;
}

struct Counts {
  std::size_t closed = 0, points = 0, empty = 0, large = 0, several_sheets = 0, crossing = 0, nodes = 0;

  void add(const RandomStroke& stroke, const Chart& chart) {
    closed += stroke.whole().closed;
    points += stroke.whole().points.size() == 1;
    empty += chart.size() == 0;
    large += chart.size() > 300;
    several_sheets += std::ranges::any_of(chart.sheet, [](auto sheet) { return sheet > 0; });
    crossing += crosses_itself(chart, stroke.options.radius);
    nodes += chart.size();
  }
};

TriangleMesh jittered(TriangleMesh mesh, float most, std::uint32_t seed) {
  Random random(seed);
  for (Vec3f& position : mesh.positions) position += most * random_vector(random);
  return mesh;
}

TriangleMesh stretched_sphere() {
  TriangleMesh mesh = test::sphere(4, 0.2, 61);
  for (Vec3f& position : mesh.positions) position.z() *= 10;
  return mesh;
}

TriangleMesh sliver_plane(float noise) {
  return jittered(test::patch({-1, 1, -1, 1, 16, 160, false, 0.3, 0.3, 62},
                              [](double u, double v) { return Vec3d(u, v, 0); }),
                  noise, 63);
}

TriangleMesh sliver_cylinder() {
  return test::patch({0, 2 * std::numbers::pi, -2, 2, 160, 10, true, 0.45, 0.45, 64},
                     [](double u, double v) { return Vec3d(std::cos(u), std::sin(u), v); });
}

struct NamedMesh {
  std::string name;
  std::function<TriangleMesh()> make;  ///< or, when empty, a file of this name
};
void PrintTo(const NamedMesh& mesh, std::ostream* out) { *out << mesh.name; }

class RandomStrokes : public testing::TestWithParam<NamedMesh> {
 protected:
  static constexpr std::uint32_t first_seed = 2026, strokes = 100;

  static void expect_sound_strokes(const Surface& surface, Counts& counts) {
    const Picker picker(surface);
    const double edge = test::mean_edge(surface);
    StrokeChartBuilder builder(surface), fresh(surface);
    for (std::uint32_t seed = first_seed; seed < first_seed + strokes && !HasFatalFailure(); ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Random random(seed);
      const RandomStroke stroke = random_stroke(surface, picker, edge, random);
      expect_sound_curve(stroke.whole());
      const Chart chart = grown(builder, stroke, random);
      test::expect_same(chart, fresh.chart(stroke.whole(), stroke.options));
      expect_sheets_in_order(chart);
      for (std::size_t i = 0; i < chart.size() && !HasFatalFailure(); ++i)
        expect_sound_node(surface, stroke, chart, i);
      expect_sound_lookup(surface, chart, random);
      counts.add(stroke, chart);
    }
  }
};

TEST_P(RandomStrokes, AreChartedSoundly) {
  TriangleMesh mesh;
  if (GetParam().make) {
    mesh = test::shuffled(GetParam().make(), 65);
  } else {
    BURIN_SHARED_DATA_OR_SKIP(file, "meshes/nasty/" + GetParam().name);
    mesh = triangulate(read_mesh(file));
  }
  const Surface surface = make_surface(std::move(mesh));
  Counts counts;
  expect_sound_strokes(surface, counts);
  std::cout << strokes << " strokes from seed " << first_seed << ": " << counts.closed << " closed, "
            << counts.points << " points, " << counts.empty << " empty charts, " << counts.large
            << " above 300 nodes, " << counts.several_sheets << " with several sheets, " << counts.crossing
            << " crossing, " << counts.nodes << " nodes of " << surface.vertex_count() << " vertices\n";
  EXPECT_GT(counts.closed, 20U);
  EXPECT_LT(counts.empty, 20U);
  EXPECT_GT(counts.several_sheets, 30U);
  EXPECT_GT(counts.crossing, 12U);
  EXPECT_TRUE(counts.large > 30 || surface.vertex_count() < 1000);
}

std::vector<NamedMesh> meshes() {
  std::vector<NamedMesh> all = {{"stretched_sphere", stretched_sphere},
                                {"sliver_plane", [] { return sliver_plane(0); }},
                                {"rough_sliver_plane", [] { return sliver_plane(0.01F); }},
                                {"sliver_cylinder", sliver_cylinder}};
  for (const char* file : {"capsule.obj", "dragon_vrip_res3.ply", "fan3.obj", "hourglass_ico.obj",
                           "moebius.obj", "not_convex.obj", "soup.stl"})
    all.push_back({file, {}});
  return all;
}

INSTANTIATE_TEST_SUITE_P(Meshes, RandomStrokes, testing::ValuesIn(meshes()),
                         [](const auto& mesh) { return test::test_name_of(mesh.param.name); });

}  // namespace
}  // namespace burin
