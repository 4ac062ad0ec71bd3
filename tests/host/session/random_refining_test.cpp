// Random strokes that refine the surface, by each rule, told where they go or not, with undo and redo: the
// Euler characteristic stays, positions are finite, and undo and redo bring the same bits back.
#include <burin/math/elementary.h>
#include <burin/surface/mesh_file.h>
#include <burin/surface/topology/defects.h>
#include <burin/surface/topology/euler.h>
#include <burin/surface/triangulate.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <random>

#include "../../refine/refined.h"
#include "../sessions.h"
#include "support/shared_data.h"

namespace burin::test {
namespace {

/// What became of many strokes.
struct Tally {
  int drawn = 0, empty = 0, refined = 0, live = 0;
  std::array<int, 3> kinds{};  ///< refined by each rule
};

/// Draws random strokes on a surface with a diagonal of about 4.
class RandomStrokes {
 public:
  RandomStrokes(TriangleMesh mesh, std::uint32_t seed)
      : random_(seed),
        has_twins_(find_defects(mesh).duplicate_triangles > 0),
        session_(make_surface(std::move(mesh)), brushes()) {}

  Tally draw(int count) {
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
      SCOPED_TRACE("stroke " + std::to_string(i));
      draw_one();
      // Strokes over and over each other would take all memory.
      constexpr std::size_t many = 300'000;
      while (session_.surface().triangles.size() > many && session_.undo()) {
      }
    }
    return tally_;
  }

 private:
  double share() { return static_cast<double>(random_()) / 4294967296.0; }
  double between(double a, double b) { return a + share() * (b - a); }

  StrokeSettings random_settings() {
    constexpr std::array<const char*, 5> names{"groove", "bead", "rope", "dashed-line", "smooth"};
    StrokeSettings made = settings(std::string("org.burin.") + names[random_() % names.size()]);
    made.fields = {};
    made.radius = between(0.08, 0.3);
    constexpr std::array kinds{Refining::Kind::automatic, Refining::Kind::edge, Refining::Kind::error};
    const std::array odds{0, 0, 0, 1, 1, 2};
    made.refining.kind = kinds[static_cast<std::size_t>(odds[random_() % odds.size()])];
    made.refining.edge = made.radius / between(5, 12);
    made.refining.error = 0.05;
    made.symmetry.mirror_x = random_() % 8 == 0;
    return made;
  }

  /// Places of a walk over the surface that turns at random, sometimes back.
  std::vector<Vec3d> walk(double step) {
    const Surface& surface = session_.surface();
    const Triangle& t = surface.triangles[random_() % surface.triangles.size()];
    Vec3d at = surface.positions[t[0]].cast<double>();
    Vec3d way = Vec3d(between(-1, 1), between(-1, 1), between(-1, 1)).normalized();
    std::vector<Vec3d> places;
    const int count = 2 + static_cast<int>(random_() % 40);
    for (int i = 0; i < count; ++i) {
      const auto found = session_.picker().closest(at.cast<float>(), 1);
      if (!found) break;
      places.push_back(found->position.cast<double>());
      const double turn = random_() % 12 == 0 ? between(2, 3.1) : between(-0.3, 0.3);
      const Vec3d axis = session_.surface().normals[found->corners[0]].cast<double>();
      way = math::cos(turn) * way + math::sin(turn) * axis.cross(way);
      at = places.back() + step * way.stableNormalized();
    }
    return places;
  }

  void draw_one() {
    const StrokeSettings with = random_settings();
    const std::vector<Vec3d> places = walk(between(0.1, 0.6) * with.radius);
    const long euler = euler_characteristic(session_.surface());
    const std::uint64_t before = session_.result_hash();
    const std::size_t refinements = session_.refinements().size(), steps = session_.undo_count();
    const bool live = random_() % 2 == 0;
    session_.begin_stroke(with, live ? std::vector<Vec3d>{} : places);
    double time = 0;
    for (const Vec3d& place : places) session_.add_sample(place, time += 0.01, {}, Show::later);
    session_.end_stroke();
    if (!has_twins_) EXPECT_EQ(euler_characteristic(session_.surface()), euler);
    EXPECT_TRUE(std::ranges::all_of(session_.positions(), [](const Vec3f& p) { return p.allFinite(); }));
    if (session_.undo_count() == steps) {
      ++tally_.empty;
      EXPECT_EQ(session_.result_hash(), before);
      return;
    }
    count(with, session_.refinements().size() > refinements, live);
    expect_undo_and_redo(before);
  }

  void count(const StrokeSettings& with, bool refined, bool live) {
    ++tally_.drawn;
    tally_.live += live;
    if (!refined) return;
    ++tally_.refined;
    const Refining::Kind kind = with.refining.kind;
    ++tally_.kinds[kind == Refining::Kind::automatic ? 0 : kind == Refining::Kind::edge ? 1 : 2];
  }

  void expect_undo_and_redo(std::uint64_t before) {
    const std::uint64_t after = session_.result_hash();
    ASSERT_TRUE(session_.undo());
    EXPECT_EQ(session_.result_hash(), before);
    if (random_() % 4 == 0) return;
    ASSERT_TRUE(session_.redo());
    EXPECT_EQ(session_.result_hash(), after);
  }

  std::mt19937 random_;
  bool has_twins_;  ///< triangles with the same corners: each split gives them one more edge in common
  Session session_;
  Tally tally_;
};

Tally draw_on(const char* name, TriangleMesh mesh, int strokes, std::uint32_t seed) {
  SCOPED_TRACE(std::string(name) + ", seed " + std::to_string(seed));
  const Tally tally = RandomStrokes(fitted(std::move(mesh)), seed).draw(strokes);
  std::cout << name << ", seed " << seed << ": " << tally.drawn << " drawn, " << tally.empty << " empty, "
            << tally.refined << " refined (" << tally.kinds[0] << " automatic, " << tally.kinds[1]
            << " edge, " << tally.kinds[2] << " error), " << tally.live << " live\n";
  return tally;
}

TEST(RandomRefining, KeepsEulerAndIsUndone) {
  const Tally on_box = draw_on("box", box({2, 1, 1}), 24, 21);
  EXPECT_GT(on_box.refined, 8);
  EXPECT_GT(std::ranges::min(on_box.kinds), 0);
  EXPECT_GT(on_box.live, 4);
}

// Soups, a one-sided strip, surfaces with edges of three triangles, slivers and a scan with defects.
TEST(RandomRefining, DISABLED_FiveHundredStrokes) {
  int drawn = 0;
  for (const char* name : {"capsule.obj", "dragon_vrip_res3.ply", "fan3.obj", "hourglass_ico.obj",
                           "moebius.obj", "not_convex.obj", "soup.stl"}) {
    const auto path = shared_data(std::string("meshes/nasty/") + name);
    if (path) drawn += draw_on(name, triangulate(read_mesh(*path)), 75, 22).drawn;
  }
  drawn += draw_on("slivers", slivers(), 75, 23).drawn;
  EXPECT_GT(drawn, 50);
}

}  // namespace
}  // namespace burin::test
