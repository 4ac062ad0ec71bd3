#include "deform/deform_fixtures.h"

#include <burin/deform/evaluate/batch.h>
#include <burin/deform/evaluate/displacement.h>
#include <burin/deform/evaluate/supported_inputs.h>
#include <burin/surface/topology/surroundings.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

#include "support/shapes.h"

namespace burin {
namespace {

class BatchTest : public ::testing::Test {
 protected:
  BatchTest() : surface_(test::square(12)) { use(test::straight_chart(surface_, 0.6f, 0.3f)); }

  void use(const Chart& chart, const ReadInputs& reads = {},
           const SurfaceCurve& curve = test::straight_curve()) {
    drawn_ = std::make_unique<test::DrawnNodes>(surface_, chart, reads, curve);
    listed_.resize(chart.size() - 5);
    std::iota(listed_.begin(), listed_.end(), 5u);
  }

  const burin_batch& fill(std::uint64_t inputs, std::span<const Vec3f> displacement = {},
                          std::uint64_t outputs = BURIN_OUTPUT_DISPLACEMENT) {
    const FootLine foot(test::straight_curve(), 0.3);
    batch_.fill({.surface = surface_, .nodes = drawn_->nodes, .radius = 0.3f, .foot = &foot}, inputs, outputs,
                params_, listed_, displacement);
    return batch_.inputs();
  }

  const burin_batch& fill_from(const NodeSource& source, std::uint64_t inputs, std::uint64_t outputs = 0,
                               std::span<const Vec3f> displacement = {}) {
    batch_.fill(source, inputs, outputs, params_, listed_, displacement);
    return batch_.inputs();
  }
  NodeSource source() const { return {.surface = surface_, .nodes = drawn_->nodes, .radius = 0.3f}; }

  Chart chart() const { return drawn_->live.nodes(); }
  Index vertex(std::size_t i) const { return drawn_->live.nodes().vertex[listed_[i]]; }

  Surface surface_;
  std::unique_ptr<test::DrawnNodes> drawn_;
  std::vector<Index> listed_;
  burin_params params_{sizeof(burin_params), 0, nullptr};
  Batch batch_;
};

float at(const burin_floats& floats, std::size_t i) { return floats.data[i * floats.stride]; }
Vec3f at(const burin_vectors& vectors, std::size_t i) {
  return {at(vectors.x, i), at(vectors.y, i), at(vectors.z, i)};
}

TEST_F(BatchTest, LeavesWhatIsNotDeclaredNull) {
  const burin_batch& batch = fill(BURIN_INPUT_D);
  EXPECT_EQ(batch.count, listed_.size());
  EXPECT_EQ(batch.params, &params_);
  EXPECT_NE(batch.d.data, nullptr);
  for (const void* array :
       {static_cast<const void*>(batch.t.data), static_cast<const void*>(batch.radius.data),
        static_cast<const void*>(batch.position.x.data), static_cast<const void*>(batch.displacement.z.data),
        static_cast<const void*>(batch.node_id.data), static_cast<const void*>(batch.sheet.data),
        static_cast<const void*>(batch.time.data), static_cast<const void*>(batch.laplacian.x.data)})
    EXPECT_EQ(array, nullptr);
  EXPECT_EQ(batch_.outputs().mask.data, nullptr);
  EXPECT_EQ(batch_.outputs().colour[0].data, nullptr);
}

TEST_F(BatchTest, LeavesOutputsThatAreNotDeclaredNullAndTheSurfaceWhereItIs) {
  fill(BURIN_INPUT_D, {}, 0);
  EXPECT_EQ(batch_.outputs().along.data, nullptr);
  EXPECT_EQ(batch_.outputs().across.data, nullptr);
  EXPECT_EQ(batch_.outputs().up.data, nullptr);
  EXPECT_EQ(batch_.displacement(3), Vec3f(0, 0, 0));
}

TEST_F(BatchTest, FillsTheNodesInTheirOrder) {
  const burin_batch& batch = fill(supported_inputs);
  ASSERT_GT(batch.count, 30u);
  for (std::size_t i = 0; i < batch.count; ++i) {
    const Vec3f& position = surface_.positions[vertex(i)];
    EXPECT_EQ(at(batch.t, i), position.x());
    EXPECT_EQ(at(batch.d, i), position.y() - 0.5f);
    EXPECT_EQ(at(batch.position.y, i), position.y());
    EXPECT_EQ(at(batch.normal.z, i), surface_.normals[vertex(i)].z());
    EXPECT_EQ(at(batch.e1.x, i), 1.0f);
    EXPECT_EQ(at(batch.stretch, i), 1.0f);
    EXPECT_EQ(batch.node_id.data[i * batch.node_id.stride], surface_.source_vertex[vertex(i)]);
  }
}

TEST_F(BatchTest, SaysOnceWhatIsTheSameForAll) {
  const burin_batch& batch = fill(supported_inputs);
  const burin_floats uniform[] = {batch.radius, batch.displacement.x, batch.pressure, batch.tilt_x,
                                  batch.time};
  for (const burin_floats& floats : uniform) EXPECT_EQ(floats.stride, 0u);
  EXPECT_EQ(*batch.radius.data, 0.3f);
  EXPECT_EQ(*batch.displacement.x.data, 0.0f);
  EXPECT_EQ(*batch.pressure.data, 1.0f);
  EXPECT_EQ(*batch.tilt_y.data, 0.0f);
}

TEST_F(BatchTest, FillsThePenWhereNodesHaveOne) {
  use(chart(), {.radius = 0.3, .inputs = BURIN_INPUT_PRESSURE, .varying = BURIN_INPUT_PRESSURE});
  const burin_batch& batch = fill(BURIN_INPUT_PRESSURE | BURIN_INPUT_SPEED);
  for (std::size_t i = 0; i < batch.count; ++i)
    EXPECT_NEAR(at(batch.pressure, i), chart().t[listed_[i]], 1e-6) << "as the curve has it";
  EXPECT_EQ(at(batch.speed, 3), 0.0f);
  EXPECT_EQ(batch.tilt_x.data, nullptr);
}

TEST_F(BatchTest, FillsTheHalfWidthWhereItVaries) {
  SurfaceCurve narrowing = test::straight_curve();
  for (CurvePoint& point : narrowing.points) point.width = 1 - 0.5f * static_cast<float>(point.t);
  use(chart(), {.radius = 0.3, .inputs = BURIN_INPUT_RADIUS, .varying = BURIN_INPUT_RADIUS}, narrowing);
  const burin_batch& batch = fill(BURIN_INPUT_RADIUS);
  for (std::size_t i = 0; i < batch.count; ++i)
    EXPECT_NEAR(at(batch.radius, i), 0.3 - 0.15 * chart().t[listed_[i]], 1e-6);
}

TEST_F(BatchTest, CountsTheSheetsOfEachVertex) {
  // Vertices with one to four nodes, in turn.
  Chart sheets = chart();
  std::vector<Index> counts;
  const std::size_t size = sheets.size();
  for (Index vertex = 0, node = 0; node < size; ++vertex)
    for (Index sheet = 0; sheet <= vertex % 4 && node < size; ++sheet, ++node) {
      sheets.vertex[node] = vertex;
      sheets.t[node] = sheet;
      sheets.sheet[node] = sheet;
    }
  for (const Index of : sheets.vertex)
    counts.push_back(static_cast<Index>(std::ranges::count(sheets.vertex, of)));
  use(sheets);
  const burin_batch& batch = fill(BURIN_INPUT_SHEET | BURIN_INPUT_VISIT_COUNT);
  ASSERT_GT(batch.count, 30u);
  for (std::size_t i = 0; i < batch.count; ++i) {
    EXPECT_EQ(batch.sheet.data[i * batch.sheet.stride], sheets.sheet[listed_[i]]);
    EXPECT_EQ(batch.visit_count.data[i * batch.visit_count.stride], counts[listed_[i]]);
  }
}

TEST_F(BatchTest, ShowsThePassBefore) {
  const std::vector<Vec3f> displacement(listed_.size(), Vec3f(0.1f, 0.2f, 0.3f));
  const burin_batch& batch = fill(BURIN_INPUT_POSITION | BURIN_INPUT_DISPLACEMENT, displacement);
  for (std::size_t i = 0; i < batch.count; ++i) {
    const Vec3f moved = surface_.positions[vertex(i)] + Vec3f(0.1f, 0.2f, 0.3f);
    EXPECT_EQ(Vec3f(at(batch.position.x, i), at(batch.position.y, i), at(batch.position.z, i)), moved);
    EXPECT_EQ(at(batch.displacement.z, i), 0.3f);
  }
}

TEST_F(BatchTest, HandsOutZeroedOutputsEveryTime) {
  fill(BURIN_INPUT_T);
  batch_.outputs().up.data[2] = 7;
  EXPECT_EQ(batch_.displacement(2), Vec3f(0, 0, 7));
  fill(BURIN_INPUT_T);
  EXPECT_EQ(batch_.displacement(2), Vec3f(0, 0, 0));
}

TEST_F(BatchTest, MeasuresCellsAlongTAndAcross) {
  Chart stretched = chart();
  std::ranges::fill(stretched.stretch, 2.0f);
  use(stretched);
  const burin_batch& batch = fill(BURIN_INPUT_FOOTPRINT);
  constexpr double edge = 1.0 / 11;
  std::size_t inner = 0;
  for (std::size_t i = 0; i < batch.count; ++i) {
    if (surface_.neighbours[vertex(i)].size() != 6) continue;
    ++inner;
    // Four of six neighbours are one edge away along either direction.
    EXPECT_NEAR(at(batch.footprint_d, i), std::sqrt(4.0 / 3) * edge, 1e-6);
    EXPECT_NEAR(at(batch.footprint_t, i), std::sqrt(4.0 / 3) * edge / 2, 1e-6)
        << "an edge is half of that in t";
  }
  EXPECT_GT(inner, 10u);
}

TEST_F(BatchTest, TellsCurvatureAndUmbrellaOfTheBase) {
  TriangleMesh bowl;
  bowl.positions = surface_.positions;
  bowl.triangles = surface_.triangles;
  for (Vec3f& place : bowl.positions) place.z() = 0.5f * (place.head<2>() - Vec2f(0.3f, 0.5f)).squaredNorm();
  surface_ = make_surface(std::move(bowl));
  use(test::straight_chart(surface_, 0.6f, 0.3f));
  const burin_batch& batch = fill(BURIN_INPUT_MEAN_CURVATURE | BURIN_INPUT_LAPLACIAN);
  constexpr float edge = 1.0f / 11;
  std::size_t inner = 0;
  for (std::size_t i = 0; i < batch.count; ++i) {
    EXPECT_EQ(at(batch.mean_curvature, i), mean_curvature(surface_, vertex(i)));
    if (surface_.neighbours[vertex(i)].size() != 6) continue;
    ++inner;
    EXPECT_LT(at(batch.mean_curvature, i), -0.5f) << "hollow seen from outside";
    // The mean of 0.5 (steps)^2: four of one edge, two of a diagonal.
    EXPECT_LT((at(batch.laplacian, i) - Vec3f(0, 0, 0.5f * 8 / 6 * edge * edge)).norm(), 1e-6f);
  }
  EXPECT_GT(inner, 10u);
}

TEST_F(BatchTest, TakesTheUmbrellaOfThePassBefore) {
  PassPositions positions(surface_, {&drawn_->live});
  const Index raised = vertex(20);
  positions.set(raised, surface_.positions[raised] + Vec3f(0, 0, 3));
  NodeSource moved = source();
  moved.before = &positions;
  const burin_batch& batch = fill_from(moved, BURIN_INPUT_LAPLACIAN);
  std::size_t beside = 0;
  for (std::size_t i = 0; i < batch.count; ++i) {
    const auto neighbours = surface_.neighbours[vertex(i)];
    const bool next_to = std::ranges::count(neighbours, raised) > 0;
    beside += next_to;
    const float share = 3 / static_cast<float>(neighbours.size());
    EXPECT_FLOAT_EQ(at(batch.laplacian.z, i), vertex(i) == raised ? -3 : next_to ? share : 0) << i;
  }
  EXPECT_GT(beside, 2u);
}

TEST_F(BatchTest, TellsMaskAndColourSoFar) {
  const burin_batch& bare = fill(BURIN_INPUT_MASK | BURIN_INPUT_COLOUR);
  EXPECT_EQ(bare.mask.stride, 0u);
  EXPECT_EQ(*bare.mask.data, 1.0f);
  EXPECT_EQ(at(bare.colour.r, 3), 1.0f);
  EXPECT_EQ(at(bare.colour.a, 3), 0.0f);
  Paint paint;
  for (const Vec3f& place : surface_.positions) {
    paint.mask.push_back(place.x());
    paint.colour.emplace_back(place.y(), place.x(), 0.25f, 0.5f);
  }
  NodeSource painted = source();
  painted.paint = &paint;
  const burin_batch& batch =
      fill_from(painted, BURIN_INPUT_MASK | BURIN_INPUT_COLOUR, BURIN_OUTPUT_MASK | BURIN_OUTPUT_COLOUR);
  for (std::size_t i = 0; i < batch.count; ++i) {
    const Vec4f& colour = paint.colour[vertex(i)];
    EXPECT_EQ(at(batch.mask, i), paint.mask[vertex(i)]);
    EXPECT_EQ(
        Vec4f(at(batch.colour.r, i), at(batch.colour.g, i), at(batch.colour.b, i), at(batch.colour.a, i)),
        colour);
    for (int k = 0; k < 4; ++k) EXPECT_EQ(batch_.outputs().colour[k].data[i], colour[k]) << "so far";
    EXPECT_EQ(batch_.outputs().mask.data[i], paint.mask[vertex(i)]);
    EXPECT_EQ(batch_.tint(i), tint_of(colour, paint.mask[vertex(i)]));
  }
}

TEST_F(BatchTest, BringsTintsIntoTheirRange) {
  constexpr float endless = std::numeric_limits<float>::infinity();
  fill(0, {}, BURIN_OUTPUT_MASK | BURIN_OUTPUT_COLOUR);
  const auto write = [&](std::size_t i, const Vec4f& colour, float mask) {
    for (int k = 0; k < 4; ++k) batch_.outputs().colour[k].data[i] = colour[k];
    batch_.outputs().mask.data[i] = mask;
  };
  write(0, {2, -1, 0.5f, 0.5f}, 7);
  write(1, {0.5f, 1, 0, 2}, -1);
  write(2, {endless, 0, 0, 0.5f}, 1);
  write(3, {0, 0, 0, 0}, std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(batch_.tint(0), tint_of({1, 0, 0.5f, 0.5f}, 1));
  EXPECT_EQ(batch_.tint(1), tint_of({0.5f, 1, 0, 1}, 0));
  EXPECT_FALSE(batch_.tint(2).allFinite());
  EXPECT_FALSE(batch_.tint(3).allFinite());
}

TEST_F(BatchTest, TellsThePlaneOfTheFoot) {
  const burin_batch& batch = fill(BURIN_INPUT_FOOT);
  const FootLine line(test::straight_curve(), 0.3);
  for (std::size_t i = 0; i < batch.count; ++i) {
    const FootPlane plane = line.at(chart().t[listed_[i]]);
    EXPECT_EQ(at(batch.foot, i), plane.position);
    EXPECT_EQ(at(batch.foot_normal, i), plane.normal);
  }
  EXPECT_NE(at(batch.foot.x, 0), at(batch.foot.x, batch.count - 1));
}

TEST_F(BatchTest, FillsDistancesFromTheEnds) {
  const burin_batch& batch = fill(BURIN_INPUT_END_DISTANCE);
  const EndDistances ends(test::straight_curve(), 0.3, 0.2);
  for (std::size_t i = 0; i < batch.count; ++i) {
    const Vec3f& position = surface_.positions[vertex(i)];
    ASSERT_EQ(at(batch.end_distance, i),
              ends.at(position.x(), position.y() - 0.5f, Vec3f::UnitX(), Vec3f::UnitZ()));
  }
}

/// A sheet of 6 radii with an egg crate on it that is narrow against the radius, and its base surface.
struct Bumpy {
  Bumpy()
      : surface(make_surface(test::patch(
            {.u_min = 0, .u_max = 6, .v_min = -2.5, .v_max = 3.5, .cells_u = 120, .cells_v = 120},
            [](double x, double y) { return Vec3d(x, y, 0.05 * std::sin(18 * x) * std::sin(18 * y)); }))),
        levels(surface),
        base(surface, levels) {
    EXPECT_TRUE(base.set_radius(1));
  }
  Surface surface;
  SurfaceLevels levels;
  BaseSurface base;
};

TEST_F(BatchTest, TellsOfTheBaseSurfaceAndOfTheFineOne) {
  Bumpy bumpy;
  test::DrawnNodes nodes(bumpy.surface, test::straight_chart(bumpy.surface, 4, 1));
  listed_.clear();
  for (Index slot = 0; slot < nodes.live.nodes().size() && listed_.size() < 900; ++slot)
    if (bumpy.surface.positions[nodes.live.nodes().vertex[slot]].x() > 2) listed_.push_back(slot);
  ASSERT_GT(listed_.size(), 600U);
  const std::vector<Vec3f> moved(listed_.size(), Vec3f(0.25F, 0, 0));
  const burin_batch& batch =
      fill_from({.surface = bumpy.surface, .nodes = nodes.nodes, .radius = 1, .base = &bumpy.base},
                supported_inputs & ~BURIN_INPUT_FOOT, 0, moved);
  float highest = 0, most_bent = 0;
  for (std::size_t i = 0; i < batch.count; ++i) {
    const Index v = nodes.live.nodes().vertex[listed_[i]];
    const Vec3f fine = bumpy.surface.positions[v];
    const Vec3f there = displaced(fine, Vec3f::UnitX(), bumpy.surface.normals[v], moved[i]);
    ASSERT_EQ(at(batch.fine_position, i), there);
    ASSERT_EQ(at(batch.fine_normal, i), bumpy.surface.normals[v]);
    ASSERT_EQ(at(batch.fine_mean_curvature, i), mean_curvature(bumpy.surface, v));
    ASSERT_NEAR(at(batch.position, i).z(), 0, 0.003);
    ASSERT_NEAR(at(batch.position, i).x(), fine.x() + 0.25F, 0.003);
    ASSERT_NEAR(at(batch.mean_curvature, i), 0, 0.05);
    highest = std::max(highest, std::abs(fine.z()));
    most_bent = std::max(most_bent, std::abs(at(batch.fine_mean_curvature, i)));
  }
  EXPECT_GT(highest, 0.045F);
  EXPECT_GT(most_bent, 5);
}

TEST_F(BatchTest, ShowsAMirrorImageTheOtherWayRound) {
  NodeSource mirrored = source();
  mirrored.mirrored = true;
  mirrored.symmetry = 5;
  const std::vector<Vec3f> before(listed_.size(), Vec3f(0.1f, 0.2f, 0.3f));
  const burin_batch& batch =
      fill_from(mirrored, BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_DISPLACEMENT | BURIN_INPUT_SYMMETRY,
                BURIN_OUTPUT_DISPLACEMENT, before);
  EXPECT_EQ(batch.symmetry.stride, 0u);
  EXPECT_EQ(*batch.symmetry.data, 5u);
  for (std::size_t i = 0; i < batch.count; ++i) {
    EXPECT_EQ(at(batch.d, i), -chart().d[listed_[i]]);
    EXPECT_EQ(at(batch.t, i), static_cast<float>(chart().t[listed_[i]]));
    EXPECT_EQ(at(batch.displacement, i), Vec3f(0.1f, -0.2f, 0.3f));
  }
  batch_.outputs().along.data[2] = 1;
  batch_.outputs().across.data[2] = 2;
  batch_.outputs().up.data[2] = 3;
  EXPECT_EQ(batch_.displacement(2), Vec3f(1, -2, 3));
}

TEST_F(BatchTest, TellsTWithinTheDab) {
  std::vector<float> dab_t(chart().size());
  std::iota(dab_t.begin(), dab_t.end(), 100.0f);
  NodeSource dabs = source();
  dabs.dab_t = dab_t;
  const burin_batch& batch = fill_from(dabs, BURIN_INPUT_T);
  for (std::size_t i = 0; i < batch.count; ++i) EXPECT_EQ(at(batch.t, i), dab_t[listed_[i]]);
}

TEST_F(BatchTest, StandsOnWhatTheStrokeMadeBefore) {
  CurrentBase current;
  const CurrentBase::Geometry geometry{{1, 2, 3}, Vec3f::UnitX(), Vec3f::UnitZ(),
                                       {7, 8, 9}, Vec3f::UnitY(), {4, 5, 6}};
  current.set(listed_[7], geometry);
  NodeSource standing = source();
  standing.current = &current;
  const burin_batch& batch =
      fill_from(standing, BURIN_INPUT_POSITION | BURIN_INPUT_NORMAL | BURIN_INPUT_E1 | BURIN_INPUT_LAPLACIAN |
                              BURIN_INPUT_DISPLACEMENT | BURIN_INPUT_FINE_POSITION | BURIN_INPUT_FINE_NORMAL);
  EXPECT_EQ(at(batch.position, 7), geometry.position);
  EXPECT_EQ(at(batch.normal, 7), geometry.normal);
  EXPECT_EQ(at(batch.e1, 7), geometry.e1);
  EXPECT_EQ(at(batch.laplacian, 7), geometry.laplacian);
  EXPECT_EQ(at(batch.fine_position, 7), geometry.fine_position);
  EXPECT_EQ(at(batch.fine_normal, 7), geometry.fine_normal);
  EXPECT_EQ(at(batch.displacement, 7), Vec3f(0, 0, 0)) << "from where it stands";
  EXPECT_EQ(at(batch.position, 8), surface_.positions[vertex(8)]);
  EXPECT_EQ(at(batch.normal, 8), surface_.normals[vertex(8)]);
  EXPECT_EQ(at(batch.e1, 8), Vec3f(1, 0, 0));
}

}  // namespace
}  // namespace burin
