#include "host/symmetric.h"

#include <gtest/gtest.h>

namespace burin {
namespace {

using test::arc;
using test::draw;
using test::octahedral_sphere;
using test::settings;
using test::SymmetricSession;

StrokeSettings lopsided(Overlap overlap = Overlap::latest) {
  StrokeSettings scales = settings("org.burin.scales", 0.2);
  scales.params = {{"stamp", std::string(BURIN_SAMPLES "/stamps/scales.exr")}, {"tile", 1.0}};
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

TEST(Symmetry, MirrorsWhatTheDirectionOfTravelDrives) {
  StrokeSettings mirrored = settings("org.burin.vdm-trail", 0.2);
  mirrored.params = {{"stamp", std::string(BURIN_SAMPLES "/stamps/thorn.exr")}};
  mirrored.dynamics = {{"angle", PenSource::direction, {-4, -4, 4, 4}},
                       {"radius", PenSource::direction, {-4, 0.4, 4, 1}}};
  mirrored.symmetry.mirror_x = true;
  const SymmetryInstance image = symmetry_instances(mirrored.symmetry)[1];
  SymmetricSession symmetric(octahedral_sphere(48), image);
  draw(symmetric.session, mirrored, arc(0.3, 1.2, 0.2));
  EXPECT_GT(symmetric.moved(), 100u);
  EXPECT_LE(symmetric.worst(image), 1e-5);
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
  EXPECT_GT(other, 50u);
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
