// Tests properties that every brush of the folder brushes/ must have.
#include <burin/abi/plugin.h>
#include <burin/base/parallel.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>
#include <set>

#include "stock_brush_uses.h"
#include "symmetric.h"

namespace burin {
namespace {

/// A unit sphere with bumps, and with dents that are narrower than a stroke of radius 0.3.
TriangleMesh bumpy(float dents = 0.02f) {
  TriangleMesh mesh = test::sphere(5, 0.2, 6);
  for (Vec3f& p : mesh.positions) {
    const float coarse = std::sin(4 * p.x()) * std::sin(5 * p.y() + 1) * std::cos(4 * p.z());
    const float fine = std::sin(17 * p.x()) * std::sin(19 * p.y()) * std::sin(18 * p.z());
    p *= 1 + 0.1f * coarse + dents * fine;
  }
  return mesh;
}

using test::BrushUse;
using test::stock_brush_uses;

class StockBrushes : public testing::TestWithParam<BrushUse> {
 protected:
  const burin_brush_descriptor& descriptor() const { return *test::brushes().find(GetParam().id).descriptor; }

  StrokeSettings stroke(double radius = 0.3) const {
    StrokeSettings settings = test::settings(GetParam().id, radius);
    settings.params = GetParam().params;
    return settings;
  }

  /// Samples beside the bumpy surface, within reach.
  static std::vector<Sample> around(const std::vector<Sample>& samples, const Session& session) {
    std::vector<Sample> placed = samples;
    for (Sample& sample : placed) {
      const Vec3f way = sample.position.cast<float>();
      sample.position = session.picker().pick({Vec3f::Zero(), way})->position.cast<double>();
    }
    return placed;
  }
};

INSTANTIATE_TEST_SUITE_P(All, StockBrushes, testing::ValuesIn(stock_brush_uses), test::name_of_use);

TEST(StockBrushFolder, HoldsTheBrushesThatAreTested) {
  std::set<std::string> tested, there;
  for (const BrushUse& use : stock_brush_uses) tested.insert(use.id);
  for (const BrushUse& use : test::solid_brush_uses) tested.insert(use.id);
  for (const BrushEntry& brush : test::brushes().brushes())
    if (brush.module.parent_path() == test::brushes_folder) there.insert(brush.descriptor->id);
  EXPECT_EQ(tested, there);
}

TEST_P(StockBrushes, LeavesTheSurfaceAloneAtStrengthZero) {
  Session session(make_surface(bumpy()), test::brushes());
  const test::Snapshot untouched(session);
  StrokeSettings settings = stroke();
  settings.strength = 0;
  test::draw(session, settings, around(test::wave_on_sphere(), session));
  EXPECT_GT(session.chart().size(), 500u);
  EXPECT_TRUE(test::Snapshot(session) == untouched);
}

/// Positions in the order of the mesh.
std::vector<Vec3d> positions_of(const Session& session) {
  std::vector<Vec3d> positions(session.surface().vertex_count());
  for (Index vertex = 0; vertex < positions.size(); ++vertex)
    positions[session.surface().source_vertex[vertex]] = session.positions()[vertex].cast<double>();
  return positions;
}

TEST_P(StockBrushes, MovesWithTheSurface) {
  const Eigen::Isometry3d motion =
      Eigen::Translation3d(0.3, -0.2, 0.4) * Eigen::AngleAxisd(1.1, Vec3d(1, -2, 0.5).normalized());
  // Without dents, at whose focal points the chart's coordinates jump.
  TriangleMesh mesh = bumpy(0);
  Session still(make_surface(mesh), test::brushes());
  const std::vector<Vec3d> base = positions_of(still);
  for (Vec3f& p : mesh.positions) p = (motion * p.cast<double>()).cast<float>();
  Session moved(make_surface(mesh), test::brushes());
  std::vector<Sample> samples = around(test::wave_on_sphere(), still);
  test::draw(still, stroke(), samples);
  for (Sample& sample : samples) sample.position = motion * sample.position;
  test::draw(moved, stroke(), samples);
  const std::vector<Vec3d> here = positions_of(still), there = positions_of(moved);
  double error = 0, displacement = 0;
  for (std::size_t i = 0; i < here.size(); ++i) {
    error = std::max(error, (there[i] - motion * here[i]).norm());
    displacement = std::max(displacement, (here[i] - base[i]).norm());
  }
  std::cout << fmt::format("off by {:.2g}, displaced by {:.2g}\n", error, displacement);
  EXPECT_LT(error, 1e-5);
  EXPECT_GT(displacement, 1e-3);
}

TEST_P(StockBrushes, IsMirroredWhereStrokesAre) {
  StrokeSettings mirrored = stroke(0.2);
  mirrored.symmetry.mirror_x = true;
  const SymmetryInstance image = symmetry_instances(mirrored.symmetry)[1];
  TriangleMesh mesh = test::octahedral_sphere(48);
  for (Vec3f& p : mesh.positions) p *= 1 + 0.05f * std::cos(4 * p.x()) * std::sin(5 * p.y() + 1);
  test::SymmetricSession symmetric(std::move(mesh), image);
  test::draw(symmetric.session, mirrored, around(test::arc(0.4, 1.2, 0.2), symmetric.session));
  EXPECT_GT(symmetric.moved(), 40u);
  const bool readable_in_mirrors = std::string_view(GetParam().id) == "org.burin.text";
  if (readable_in_mirrors) {
    EXPECT_GT(symmetric.worst(image), 1e-3);
  } else {
    EXPECT_LE(symmetric.worst(image), 1e-5);
  }
}

TEST_P(StockBrushes, GivesTheSameBitsHoweverItIsShownAndOnHowManyThreads) {
  std::set<std::uint64_t> hashes;
  for (const std::size_t threads : {1u, 2u}) {
    for (const std::size_t show_every : {1u, 7u, 1000u}) {
      const ThreadLimit limit(threads);
      Session session(make_surface(bumpy()), test::brushes());
      session.begin_stroke(stroke());
      std::size_t i = 0;
      for (const Sample& sample : around(test::wave_on_sphere(), session))
        session.add_sample(sample.position, sample.time, sample.pen,
                           ++i % show_every == 0 ? Show::now : Show::later);
      session.end_stroke();
      hashes.insert(session.result_hash());
    }
  }
  EXPECT_EQ(hashes.size(), 1u);
}

/// Values all over the sliders.
ParamSettings random_params(const burin_brush_descriptor& brush, std::mt19937& engine) {
  ParamSettings params;
  for (std::uint32_t i = 0; i < brush.param_count; ++i) {
    const burin_param_info& param = *brush.params[i];
    if (param.type == BURIN_PARAM_FLOAT)
      params[param.id] =
          static_cast<double>(std::uniform_real_distribution(param.soft_min, param.soft_max)(engine));
    if (param.type != BURIN_PARAM_INT && param.type != BURIN_PARAM_CHOICE) continue;
    const int value = std::uniform_int_distribution(static_cast<int>(param.soft_min),
                                                    static_cast<int>(param.soft_max))(engine);
    if (param.type == BURIN_PARAM_INT) params[param.id] = static_cast<double>(value);
    if (param.type == BURIN_PARAM_CHOICE) params[param.id] = std::string(param.choices[value]);
  }
  return params;
}

TEST_P(StockBrushes, StaysFiniteOnRandomStrokes) {
  const unsigned seed = std::random_device{}();
  std::cout << "seed " << seed << '\n';
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> around_zero(-1, 1);
  Session session(make_surface(bumpy()), test::brushes());
  int drawn = 0;
  for (int count : {1, 2, 5, 20, 60}) {
    StrokeSettings settings = stroke(std::exp(-2 + around_zero(engine)));
    settings.params.merge(random_params(descriptor(), engine));
    settings.pressure_width = 0.5 + around_zero(engine) / 2;
    settings.fields = {.time = true, .pressure = true};
    settings.overlap = static_cast<Overlap>(engine() % 6);
    session.begin_stroke(settings);
    Vec3d way = Vec3d(around_zero(engine), around_zero(engine), around_zero(engine)).normalized();
    Vec3d turn = Vec3d(around_zero(engine), around_zero(engine), around_zero(engine)) * settings.radius;
    for (int i = 0; i < count; ++i) {
      way = (way + turn.cross(way)).normalized();
      turn += 0.3 * settings.radius * Vec3d(around_zero(engine), around_zero(engine), around_zero(engine));
      const float pressure = static_cast<float>(0.5 + around_zero(engine) / 2);
      const StrokeEvent event =
          session.add_sample(Ray{Vec3f::Zero(), way.cast<float>()}, 0.01 * i, {.pressure = pressure});
      drawn += event.outcome == StrokeEvent::Outcome::drawn;
    }
    session.end_stroke(count > 10 ? Closure::automatic : Closure::open);
    for (Index vertex = 0; vertex < session.surface().vertex_count(); ++vertex)
      ASSERT_TRUE(session.positions()[vertex].allFinite() && session.normals()[vertex].allFinite()) << vertex;
  }
  EXPECT_GT(drawn, 20);
}

}  // namespace
}  // namespace burin
