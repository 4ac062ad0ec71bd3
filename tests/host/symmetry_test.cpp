#include "sessions.h"

#include <burin/surface/picker.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin {
namespace {

using test::draw;
using test::settings;

/// The farthest that the image of a vertex is from the surface's vertex nearest to where it was before.
/// A mesh that has the symmetry: what one vertex does, its image does mirrored or turned.
class SymmetricSession {
 public:
  SymmetricSession(TriangleMesh mesh, const SymmetryInstance& image)
      : session(make_surface(std::move(mesh)), test::brushes()), base(session.surface().positions) {
    const Picker picker(session.surface());
    for (const Vec3f& place : base) {
      const auto at = picker.closest(image(place.cast<double>()).cast<float>(), 0.1f);
      const auto nearest = std::ranges::max_element(at->weights) - at->weights.begin();
      image_of.push_back(at->corners[static_cast<std::size_t>(nearest)]);
    }
  }

  double worst(const SymmetryInstance& image) const {
    double worst = 0;
    for (Index vertex = 0; vertex < base.size(); ++vertex) {
      const Vec3d expected = image(session.positions()[vertex].cast<double>());
      worst = std::max(worst, (expected - session.positions()[image_of[vertex]].cast<double>()).norm());
    }
    return worst;
  }
  std::size_t moved() const {
    std::size_t count = 0;
    for (Index vertex = 0; vertex < base.size(); ++vertex)
      count += session.positions()[vertex] != base[vertex];
    return count;
  }

  Session session;
  std::vector<Vec3f> base;
  std::vector<Index> image_of;
};

/// An octahedron whose triangles are split, on the unit sphere: symmetric in all axes, and by quarter turns.
TriangleMesh octahedral_sphere(int cells) {
  TriangleMesh mesh;
  for (int face = 0; face < 8; ++face) {
    const float x = face & 1 ? -1 : 1, y = face & 2 ? -1 : 1, z = face & 4 ? -1 : 1;
    const bool flip = x * y * z < 0;
    std::vector<std::vector<Index>> rows;
    for (int i = 0; i <= cells; ++i) {
      rows.emplace_back();
      for (int j = 0; j <= cells - i; ++j) {
        const auto a = static_cast<float>(i), b = static_cast<float>(j),
                   c = static_cast<float>(cells - i - j);
        const Vec3f place = Vec3f(x * a, y * b, z * c).normalized();
        const auto known = std::ranges::find(mesh.positions, place);
        rows.back().push_back(static_cast<Index>(known - mesh.positions.begin()));
        if (known == mesh.positions.end()) mesh.positions.push_back(place);
      }
    }
    const auto add = [&](Index p, Index q, Index r) {
      mesh.triangles.push_back(flip ? Triangle{p, r, q} : Triangle{p, q, r});
    };
    for (std::size_t i = 0; i + 1 < rows.size(); ++i)
      for (std::size_t j = 0; j + 1 < rows[i].size(); ++j) {
        add(rows[i][j], rows[i + 1][j], rows[i][j + 1]);
        if (j + 2 < rows[i].size()) add(rows[i + 1][j], rows[i + 1][j + 1], rows[i][j + 1]);
      }
  }
  return mesh;
}

std::vector<Sample> arc(double from, double to, double height) {
  std::vector<Sample> samples;
  for (int i = 0; i <= 30; ++i) {
    const double angle = from + (to - from) * i / 30;
    Sample sample;
    sample.time = 0.01 * i;
    sample.position =
        Vec3d(std::cos(angle), height + 0.1 * std::sin(3 * angle), std::sin(angle)).normalized();
    samples.push_back(sample);
  }
  return samples;
}

StrokeSettings lopsided(Overlap overlap = Overlap::latest) {
  StrokeSettings scales = settings("org.burin.scales", 0.2);
  scales.params = {{"stamp", std::string(BURIN_SAMPLES) + "/stamps/scales.exr"}, {"tile", 1.0}};
  scales.overlap = overlap;
  return scales;
}

TEST(Symmetry, MirrorsWhatALopsidedBrushDoes) {
  for (const Overlap overlap : {Overlap::latest, Overlap::max, Overlap::add, Overlap::average}) {
    for (const double to : {1.2, 2.2}) {  // away from the mirror plane x = 0, and across it
      StrokeSettings mirrored = lopsided(overlap);
      mirrored.symmetry.mirror_x = true;
      const SymmetryInstance image = symmetry_instances(mirrored.symmetry)[1];
      SymmetricSession symmetric(octahedral_sphere(48), image);
      draw(symmetric.session, mirrored, arc(0.3, to, 0.2));
      EXPECT_GT(symmetric.moved(), 300u);
      EXPECT_LE(symmetric.worst(image), 1e-5) << to << ' ' << static_cast<int>(overlap);
    }
  }
}

TEST(Symmetry, TurnsAStrokeAroundAnAxis) {
  StrokeSettings radial = lopsided();
  radial.symmetry.radial = 4;
  const SymmetryInstance image = symmetry_instances(radial.symmetry)[1];
  SymmetricSession symmetric(octahedral_sphere(48), image);
  draw(symmetric.session, radial, arc(0.3, 1.6, 0.2));
  EXPECT_GT(symmetric.moved(), 600u);
  EXPECT_LE(symmetric.worst(image), 1e-5);
}

TEST(Symmetry, TellsTheBrushTheInstance) {
  StrokeSettings every = settings("org.burin.test.every-input", 0.2);
  Session plain(make_surface(octahedral_sphere(32)), test::brushes()),
      mirrored(make_surface(octahedral_sphere(32)), test::brushes());
  draw(plain, every, arc(0.4, 1.0, 0.2));
  every.symmetry.mirror_x = true;
  draw(mirrored, every, arc(0.4, 1.0, 0.2));
  // This brush adds to its displacement with the instance, so that the image differs from the original.
  std::size_t same = 0, other = 0;
  for (Index vertex = 0; vertex < plain.surface().vertex_count(); ++vertex) {
    const Vec3f& place = plain.surface().positions[vertex];
    if (place.x() > 0.3f) same += place == mirrored.surface().positions[vertex];
    if (place.x() < -0.3f) other += place != mirrored.surface().positions[vertex];
  }
  EXPECT_GT(same, 300u);
  EXPECT_GT(other, 300u);
}

TEST(Symmetry, IsUndoneAsOneStroke) {
  Session session = test::sphere_session();
  const test::Snapshot before(session);
  StrokeSettings groove = settings("org.burin.groove");
  groove.symmetry = {.mirror_x = true, .mirror_y = true, .radial = 3};
  draw(session, groove, test::wave_on_sphere());
  EXPECT_FALSE(test::Snapshot(session) == before);
  EXPECT_TRUE(session.undo());
  EXPECT_TRUE(test::Snapshot(session) == before);
}

TEST(Symmetry, LeavesOutImagesThatMeetNoSurface) {
  Session session = test::plane_session();  // all of it at |x| <= 1
  StrokeSettings groove = settings("org.burin.groove");
  groove.symmetry.mirror_x = true;
  groove.symmetry.centre = Vec3d(5, 0, 0);
  draw(session, groove, test::wave());
  Session plain = test::plane_session();
  draw(plain, settings("org.burin.groove"), test::wave());
  EXPECT_EQ(session.result_hash(), plain.result_hash());
}

}  // namespace
}  // namespace burin
