// Tests symmetric images of strokes on surfaces that are symmetric only in part.
#include <burin/host/session/image_chart.h>

#include <algorithm>
#include <cmath>

#include "host/mirrored_hills.h"
#include "host/sessions.h"

namespace burin {
namespace {

using test::draw;
using test::settings;

constexpr double radius = 0.2;

/// Symmetric but for a slope on the right, above y = 0.1 and beside the way of the pen.
TriangleMesh partly_symmetric() {
  TriangleMesh mesh = test::mirrored_hills();
  for (Vec3f& p : mesh.positions)
    if (p.x() > 0.53f && p.y() > 0.1f) p.z() += 2 * (p.x() - 0.53f) * (p.y() - 0.1f);
  return mesh;
}

/// Samples on the right, upwards; or on the left.
std::vector<Sample> upwards(double side, double to) {
  std::vector<Sample> samples;
  for (int i = 0; i <= 30; ++i) {
    const double s = i / 30.;
    samples.push_back({0.01 * i, Vec3d(side * (0.3 + 0.1 * std::sin(4 * s)), -0.5 + s * (to + 0.5), 0), {}});
  }
  return samples;
}

StrokeSettings mirrored(double dab_spacing = 0) {
  StrokeSettings groove = settings("org.burin.groove", radius);
  groove.symmetry.mirror_x = true;
  groove.dab_spacing = dab_spacing;
  return groove;
}

TEST(ImageChart, GrowsToWhatIsDrawnAtOnce) {
  for (const double spacing : {0., 0.5}) {
    for (const double to : {-0.2, 0.5}) {  // below the slope, and beside it
      Session shown(make_surface(partly_symmetric()), test::brushes());
      Session held(make_surface(partly_symmetric()), test::brushes());
      const test::Snapshot before(shown);
      draw(shown, mirrored(spacing), upwards(1, to));
      held.begin_stroke(mirrored(spacing));
      for (const Sample& sample : upwards(1, to))
        held.add_sample(sample.position, sample.time, sample.pen, Show::later);
      held.end_stroke();
      EXPECT_EQ(shown.result_hash(), held.result_hash()) << spacing << ' ' << to;
      EXPECT_TRUE(shown.undo());
      EXPECT_TRUE(test::Snapshot(shown) == before);
    }
  }
}

TEST(ImageChart, IsTheImagesOwnWhereTheSurfaceIsNotSymmetric) {
  for (const double spacing : {0., 0.5}) {
    Session images(make_surface(partly_symmetric()), test::brushes());
    Session by_hand(make_surface(partly_symmetric()), test::brushes());
    draw(images, mirrored(spacing), upwards(1, 0.5));
    StrokeSettings plain = mirrored(spacing);
    plain.symmetry = {};
    draw(by_hand, plain, upwards(-1, 0.5));
    double worst = 0;
    std::size_t moved = 0;
    for (Index v = 0; v < images.surface().vertex_count(); ++v) {
      const Vec3f &place = images.positions()[v], &there = by_hand.positions()[v];
      if (by_hand.surface().positions[v].x() > 0) continue;
      worst = std::max(worst, static_cast<double>((place - there).norm()));
      moved += there.z() < partly_symmetric().positions[by_hand.surface().source_vertex[v]].z();
    }
    EXPECT_LT(worst, 1e-6) << spacing;
    EXPECT_GT(moved, 50u);
  }
}

TEST(ImageChart, HasTheImagesOfAllNodesOrNone) {
  const Surface surface = make_surface(partly_symmetric());
  const Picker picker(surface);
  Symmetry symmetry;
  symmetry.mirror_x = true;
  const SymmetryInstance image = symmetry_instances(symmetry)[1];
  LiveChart original(surface.vertex_count()), kept(surface.vertex_count());
  ImageChart chart(surface, picker, image, radius, kept);
  const auto vertex_near = [&](const Vec3f& place) {
    return static_cast<Index>(
        std::ranges::min_element(surface.positions, {},
                                 [&](const Vec3f& p) { return (p - place).head<2>().norm(); }) -
        surface.positions.begin());
  };
  const Index low = vertex_near({0.2f, -0.2f, 0}), low_image = vertex_near({-0.2f, -0.2f, 0});
  original.begin_event(1, false, 0);
  original.set(0, low, {.t = 0.3, .d = 0.1f, .e1 = Vec3f(0.6f, 0.8f, 0), .curvature = 2, .stretch = 1},
               surface.normals[low]);
  ASSERT_TRUE(chart.has_images_of(original));
  EXPECT_TRUE(chart.own_is_behind());
  chart.reflect(original);
  ASSERT_EQ(chart.live().first(low_image), 0u);
  EXPECT_EQ(chart.live().nodes().frame(0),
            (ChartFrame{.t = 0.3, .d = -0.1f, .e1 = Vec3f(-0.6f, 0.8f, 0), .curvature = -2, .stretch = 1}));
  EXPECT_EQ(chart.live().first(low), no_index);

  const Index on_the_slope = vertex_near({0.6f, 0.5f, 0});
  original.begin_event(1, false, 0);
  original.set(1, on_the_slope, {.t = 0.9, .d = 0, .e1 = Vec3f::UnitX(), .curvature = 0, .stretch = 1},
               surface.normals[on_the_slope]);
  EXPECT_FALSE(chart.has_images_of(original));
  original.begin_event(1, false, 0);
  original.remove(1);
  EXPECT_TRUE(chart.has_images_of(original));
}

}  // namespace
}  // namespace burin
