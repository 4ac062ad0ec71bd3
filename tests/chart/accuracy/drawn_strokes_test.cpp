// Compares charts of hand-drawn strokes with exact distances: hooks, corners, cusps, retraced and scrubbed
// lines, rests, loops and spirals tighter than the radius. Every vertex near the stroke has a node, and
// the least distance among its nodes is the exact geodesic distance from the curve.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <set>
#include <string>

#include "support/charted.h"
#include "support/drawn_strokes.h"
#include "support/same_chart.h"
#include "support/shapes.h"
#include "support/told_distances.h"

namespace burin {
namespace {

/// Vertices of which nothing is asked at the rim, where half an edge decides: share of the radius.
constexpr double asked_of_strokes = 0.97;

/// Geodesic distances to a curve on a shape.
class ExactDistance {
 public:
  ExactDistance(const test::ExactShape& shape, const SurfaceCurve& curve) : shape_(&shape) {
    for (const CurvePoint& point : curve.points) places_.emplace_back(point.at.position.cast<double>());
    for (std::size_t i = 0; i + 1 < places_.size(); ++i)
      lengths_.push_back((places_[i + 1] - places_[i]).norm());
  }

  /// That of a point; more than `most` where it is farther.
  double operator()(const Vec3d& x, double most) const {
    double least = shape_->distance(x, places_[0], places_[0]), bound = std::min(most, least);
    for (std::size_t i = 0; i < lengths_.size(); ++i) {
      // Straight lines are shorter than any way on the surface.
      const double reach = bound + lengths_[i];
      if ((x - places_[i]).squaredNorm() > reach * reach) continue;
      least = std::min(least, shape_->distance(x, places_[i], places_[i + 1]));
      bound = std::min(bound, least);
    }
    return least;
  }

 private:
  const test::ExactShape* shape_;
  std::vector<Vec3d> places_;
  std::vector<double> lengths_;  ///< [i] from a place to the next one
};

test::ToldErrors compare(const test::ExactShape& shape, const Surface& surface, const SurfaceCurve& curve,
                         const Chart& chart, double radius) {
  const std::map<Index, double> told = test::told_distances(chart);
  const ExactDistance distance(shape, curve);
  Eigen::AlignedBox3d box;
  for (const CurvePoint& point : curve.points) box.extend(point.at.position.cast<double>());
  test::ToldErrors errors;
  for (Index vertex = 0; vertex < surface.vertex_count(); ++vertex) {
    const Vec3d x = surface.positions[vertex].cast<double>();
    if (box.squaredExteriorDistance(x) > radius * radius) continue;
    const double exact = distance(x, radius);
    if (exact > asked_of_strokes * radius) continue;
    errors.add(told, vertex, exact, radius);
  }
  return errors;
}

std::vector<Vec3d> laid_onto(const test::ExactShape& shape, const std::vector<Vec2d>& in_radii,
                             double radius) {
  std::vector<Vec3d> samples;
  samples.reserve(in_radii.size());
  for (const Vec2d& sample : in_radii) samples.push_back(shape.place(radius * sample));
  return samples;
}

struct Drawing {
  std::unique_ptr<test::ExactShape> shape;
  double follow;
  double edge, reach;  ///< of the mesh, object units
  double least_radius, most_radius;
  int strokes_a_kind;
  std::uint32_t seed;
  Join join = Join::round;
};

struct StrokeTally {
  std::size_t strokes = 0;
  test::ToldErrors errors;

  void add(const StrokeTally& other) {
    strokes += other.strokes;
    errors.add(other.errors);
  }
};

std::ostream& operator<<(std::ostream& out, const StrokeTally& tally) {
  return out << tally.strokes << " strokes, " << tally.errors;
}

StrokeTally draw_all(const Drawing& drawing) {
  test::Charted charted(drawing.shape->mesh(drawing.edge, drawing.reach, drawing.seed));
  std::mt19937 random(drawing.seed);
  StrokeTally all;
  for (const std::string_view kind : test::drawn_kinds()) {
    StrokeTally of_kind;
    for (int i = 0; i < drawing.strokes_a_kind; ++i) {
      const double share = static_cast<double>(random()) / 4294967296.;
      const double radius =
          drawing.least_radius * std::pow(drawing.most_radius / drawing.least_radius, share);
      const auto samples = laid_onto(*drawing.shape, test::drawn_stroke(kind, random), radius);
      const Chart chart =
          charted.chart({.radius = radius, .join = drawing.join, .follow = drawing.follow}, samples);
      of_kind.add({1, compare(*drawing.shape, charted.surface, charted.curve, chart, radius)});
    }
    std::cout << "  " << kind << ": " << of_kind << "\n";
    all.add(of_kind);
  }
  std::cout << "seed " << drawing.seed << ": " << all << "\n";
  return all;
}

constexpr double all_relief = 1, own_scale = 0;

void expect_right(const StrokeTally& tally) {
  EXPECT_GT(tally.errors.vertices, 100'000U);
  EXPECT_EQ(tally.errors.holes, 0U);
  EXPECT_LE(10'000 * tally.errors.off_2, tally.errors.vertices);
  EXPECT_EQ(tally.errors.off_10, 0U);
}

// Radii of 3 to 12 edges, and of 12 to 60.
TEST(DrawnStrokes, HaveExactDistancesOnThePlane) {
  StrokeTally all;
  all.add(draw_all({test::exact_plane(), all_relief, 0.02, 1.05, 0.06, 0.24, 30, 11}));
  all.add(draw_all({test::exact_plane(), all_relief, 0.005, 1.25, 0.06, 0.3, 10, 12}));
  EXPECT_GE(all.strokes, 500U);
  expect_right(all);
}

// Radii of 3 to 16 edges, and of 14 to 50.
TEST(DrawnStrokes, HaveExactDistancesOnACylinder) {
  StrokeTally all = draw_all({test::exact_cylinder(), all_relief, 0.015, 1.05, 0.05, 0.24, 10, 13});
  all.add(draw_all({test::exact_cylinder(), all_relief, 0.005, 1.05, 0.07, 0.25, 4, 16}));
  expect_right(all);
}

TEST(DrawnStrokes, HaveExactDistancesOnACone) {
  StrokeTally all = draw_all({test::exact_cone(), all_relief, 0.015, 1.05, 0.05, 0.24, 10, 14});
  all.add(draw_all({test::exact_cone(), all_relief, 0.005, 1.05, 0.07, 0.25, 4, 17}));
  expect_right(all);
}

TEST(DrawnStrokes, HaveExactDistancesOnASphere) {
  StrokeTally all = draw_all({test::exact_sphere(), all_relief, 0.017, 1.05, 0.05, 0.24, 10, 15});
  all.add(draw_all({test::exact_sphere(), all_relief, 0.0045, 1.05, 0.07, 0.25, 4, 18}));
  expect_right(all);
}

class JoinedStrokes : public testing::TestWithParam<Join> {};

// Where a smooth or mitered stroke bends, distances are others than to the stroke, but each vertex within the
// radius of the stroke has a node, whatever the join. With overlap, distances are those to the stroke.
TEST_P(JoinedStrokes, HaveNoHoles) {
  StrokeTally all = draw_all({test::exact_plane(), all_relief, 0.02, 1.05, 0.06, 0.24, 15, 51, GetParam()});
  all.add(draw_all({test::exact_plane(), all_relief, 0.005, 1.25, 0.06, 0.3, 3, 52, GetParam()}));
  all.add(draw_all({test::exact_sphere(), all_relief, 0.034, 1.05, 0.1, 0.24, 4, 53, GetParam()}));
  all.add(draw_all({test::exact_plane(), own_scale, 0.01, 1.15, 0.12, 0.27, 4, 54, GetParam()}));
  all.add(draw_all({test::exact_sphere(), own_scale, 0.017, 1.15, 0.2, 0.3, 2, 55, GetParam()}));
  EXPECT_GT(all.errors.vertices, 100'000U);
  EXPECT_EQ(all.errors.holes, 0U);
  if (GetParam() == Join::overlap) expect_right(all);
}

INSTANTIATE_TEST_SUITE_P(DrawnStrokes, JoinedStrokes,
                         testing::Values(Join::smooth, Join::miter, Join::overlap),
                         [](const auto& joined) { return std::string(name_of(named_joins, joined.param)); });

TEST(DrawnStrokes, HaveExactDistancesAtTheBrushesOwnScale) {
  StrokeTally all;
  all.add(draw_all({test::exact_plane(), own_scale, 0.01, 1.15, 0.12, 0.27, 25, 21}));
  all.add(draw_all({test::exact_cylinder(), own_scale, 0.01, 1.15, 0.12, 0.27, 4, 22}));
  all.add(draw_all({test::exact_cone(), own_scale, 0.01, 1.15, 0.12, 0.27, 4, 23}));
  all.add(draw_all({test::exact_sphere(), own_scale, 0.0085, 1.15, 0.12, 0.27, 4, 24}));
  expect_right(all);
}

/// Expects that the last event computed all nodes from the arc length on that it tells.
void expect_all_computed(const LiveChart& live) {
  const std::set<Index> computed(live.computed().begin(), live.computed().end());
  for (Index slot = 0; slot < live.nodes().size(); ++slot)
    if (!live.vacant(slot) && live.nodes().t[slot] >= live.computed_from())
      ASSERT_TRUE(computed.contains(slot)) << "t " << live.nodes().t[slot];
}

/// Two builders on the same mesh.
struct TwoCharts {
  explicit TwoCharts(const TriangleMesh& mesh) : growing(mesh), fresh(mesh) {}

  /// Expects that a stroke that grows sample by sample has the chart of the stroke in one go, bit for bit,
  /// after every so many samples and at its end.
  void expect_same(const std::vector<Vec3d>& samples, const ChartOptions& options, std::size_t every) {
    growing.builder.begin(options);
    CurveTracer tracer(CurveGround(growing.surface, growing.picker, growing.builder.base()), options.radius);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto at = growing.picker.closest(samples[i].cast<float>(), 0.5F);
      ASSERT_TRUE(at.has_value());
      const std::size_t unchanged = tracer.final_points();
      tracer.add(*at, static_cast<double>(i) / 240, {});
      const LiveChart& live = growing.builder.draw(tracer.curve(), unchanged);
      expect_all_computed(live);
      const Chart grown = live.sorted();
      if (i % every != every - 1 && i + 1 != samples.size()) continue;
      test::expect_same(grown, fresh.builder.chart(tracer.curve(), options));
      if (testing::Test::HasFailure()) FAIL() << "after sample " << i;
    }
  }

  test::Charted growing, fresh;
};

void expect_to_grow(double follow, std::uint32_t seed, Join join = Join::round) {
  TwoCharts charts(test::plane(1.05, 0.02, seed));
  std::mt19937 random(seed);
  const double radius = 0.2;
  for (const std::string_view kind : test::drawn_kinds()) {
    const auto samples = laid_onto(*test::exact_plane(), test::drawn_stroke(kind, random), radius);
    charts.expect_same(samples, {.radius = radius, .join = join, .follow = follow}, 7);
    if (testing::Test::HasFailure()) FAIL() << kind << ", seed " << seed;
  }
}

TEST(DrawnStrokes, GrowBitForBit) {
  for (const std::uint32_t seed : {31U, 32U, 33U}) {
    expect_to_grow(all_relief, seed);
    expect_to_grow(own_scale, seed);
  }
}

/// Triangles nearly three times as long as wide. Many vertices have several visits.
TriangleMesh long_triangles() {
  TriangleMesh mesh = test::plane(1.05, 0.07, 60);
  for (Vec3f& p : mesh.positions) p.x() *= 2.8F;
  return mesh;
}

const ChartOptions on_long_triangles{.radius = 0.47, .follow = own_scale};

// A visit that begins far from the stroke decides whether a node near it belongs to an earlier visit.
TEST(DrawnStrokes, GrowBitForBitWhereAFarVisitBegins) {
  TwoCharts charts(long_triangles());
  charts.expect_same({{0.14178992373593957, -0.14581715800955031, 0},
                      {-0.067481785130130201, -0.14849219212050896, 0},
                      {0.01995453676749448, -0.035568791260138094, 0},
                      {-0.11631507388670481, 0.030963409673592596, 0},
                      {-0.23907921922083245, 0.080612640423135595, 0}},
                     on_long_triangles, 1);
}

// The begin of the stroke is the nearest place for two visits of a vertex.
TEST(DrawnStrokes, GrowBitForBitWhereTwoVisitsHaveTheSameFoot) {
  TwoCharts charts(long_triangles());
  charts.expect_same({{-0.082975004990881202, -0.0051528142368461038, 0},
                      {0.13172198840110663, -0.022945425105325934, 0},
                      {0.0095016839397812219, -0.10722906547723084, 0},
                      {0.11384690201729857, -0.17998987235905833, 0},
                      {0.29969278043319297, -0.24390522513574447, 0}},
                     on_long_triangles, 1);
}

TEST(DrawnStrokes, GrowBitForBitWithSparseSamples) {
  const std::uint32_t seed = 61;
  std::mt19937 random(seed);
  TwoCharts charts(long_triangles());
  std::uniform_real_distribution<double> step(-0.235, 0.235);
  for (int stroke = 0; stroke < 300; ++stroke) {
    std::vector<Vec3d> samples{Vec3d(step(random), step(random), 0)};
    for (int i = 0; i < 4; ++i) samples.push_back(samples.back() + Vec3d(step(random), step(random) / 2, 0));
    charts.expect_same(samples, on_long_triangles, 1);
    if (testing::Test::HasFailure()) FAIL() << "stroke " << stroke << ", seed " << seed;
  }
}

/// Leaning towers on a plane, as strokes over strokes build them: two to ten edges high, on bases that are
/// five edges wide.
TriangleMesh towers(std::uint32_t seed) {
  TriangleMesh mesh = test::plane(1.05, 0.02, seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  const auto centred = [&] { return static_cast<float>(share(random) - 0.5); };
  for (int tower = 0; tower < 100; ++tower) {
    const float y = centred(), x = centred();
    const auto height = static_cast<float>(8 * 0.02 * (0.3 + share(random)));
    const float lean_y = centred(), lean_x = centred();
    for (Vec3f& p : mesh.positions) {
      const float inside = 1 - (p.head<2>() - Vec2f(x, y)).squaredNorm() / (0.05F * 0.05F);
      if (inside > 0) p += height * inside * inside * Vec3f(lean_x, lean_y, 1);
    }
  }
  return mesh;
}

// Along steep flanks t is stretched so much that frames are held against parts of the stroke, or its end,
// that are far from the vertex.
TEST(DrawnStrokes, GrowBitForBitOverTowers) {
  TwoCharts charts(towers(4));
  const ChartOptions options{.radius = 0.4, .follow = all_relief};
  charts.expect_same({{-0.145155704892441, 0.13736013817072, 0},
                      {0.018283421884823, -0.12934130431979, 0},
                      {0.255182314575607, -0.32346012707581, 0},
                      {0.290731144272845, -0.08515054883756, 0},
                      {0.309907558905630, -0.07940965363418, 0},
                      {0.411929222614827, -0.32967277724158, 0}},
                     options, 1);
  charts.expect_same({{-0.186519196199394, 0.181197586998582, 0},
                      {0.066378614079915, 0.132007325461959, 0},
                      {0.242968258389168, 0.176115033532764, 0},
                      {0.265313148836539, -0.090992926696720, 0},
                      {0.244998045198957, 0.122970263770248, 0},
                      {0.066277399474837, 0.115062771069679, 0}},
                     options, 1);
}

/// The rectangle from (-1.5, -0.5) with so many columns and rows of squares, all cut along the same diagonal.
TriangleMesh square_grid(Index columns, Index rows, float edge) {
  TriangleMesh mesh;
  for (Index y = 0; y <= rows; ++y)
    for (Index x = 0; x <= columns; ++x)
      mesh.positions.emplace_back(edge * static_cast<float>(x) - 1.5F, edge * static_cast<float>(y) - 0.5F,
                                  0.F);
  for (Index y = 0; y < rows; ++y)
    for (Index x = 0; x < columns; ++x) {
      const Index corner = y * (columns + 1) + x, above = corner + columns + 1;
      mesh.triangles.push_back({corner, corner + 1, above});
      mesh.triangles.push_back({corner + 1, above + 1, above});
    }
  return mesh;
}

// The columns of vertices on either side of the begin are equally far from it, and the way from the one to
// the other runs along the front.
TEST(DrawnStrokes, HaveExactDistancesWhereAWayRunsAlongTheFront) {
  constexpr double radius = 0.2;
  const auto shape = test::exact_plane();
  test::Charted charted(square_grid(100, 50, 0.02F));
  std::vector<Vec3d> samples{{-0.99, 0.007, 0}, {-0.995, 0.0035, 0}};
  for (int i = 0; i <= 100; ++i) samples.emplace_back(-1 + 0.01 * i, 0, 0);
  const Chart chart = charted.chart({.radius = radius, .follow = all_relief}, samples);
  const test::ToldErrors errors = compare(*shape, charted.surface, charted.curve, chart, radius);
  EXPECT_GT(errors.vertices, 1000U);
  EXPECT_EQ(errors.holes, 0U);
  EXPECT_LE(errors.worst, 0.01);
}

class JoinedStrokesThatGrow : public testing::TestWithParam<Join> {};

TEST_P(JoinedStrokesThatGrow, GrowBitForBit) {
  expect_to_grow(all_relief, 34, GetParam());
  expect_to_grow(own_scale, 35, GetParam());
}

INSTANTIATE_TEST_SUITE_P(DrawnStrokes, JoinedStrokesThatGrow,
                         testing::Values(Join::smooth, Join::miter, Join::overlap),
                         [](const auto& joined) { return std::string(name_of(named_joins, joined.param)); });

}  // namespace
}  // namespace burin
