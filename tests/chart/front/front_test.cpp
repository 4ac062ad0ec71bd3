#include <burin/chart/front/front.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>

#include "support/shapes.h"
#include "support/traced.h"

namespace burin {
namespace {

struct Placed {
  Index vertex;
  ChartFrame frame;
  bool operator==(const Placed&) const = default;
};

std::vector<Placed> placed(Front& front) {
  std::vector<Placed> nodes;
  for (const auto& part : front.inside())
    for (const FrontNode* node : part) nodes.push_back({node->vertex(), node->frame});
  return nodes;
}

/// Some strokes around the unit sphere that cross themselves.
std::vector<Vec3d> random_samples(std::mt19937& random) {
  const auto number = [&] { return static_cast<double>(random() % 2001) / 1000 - 1; };
  std::vector<Vec3d> samples = {Vec3d(number(), number(), 1).normalized()};
  Vec3d way = 0.2 * Vec3d(number(), number(), number());
  while (samples.size() < 30) {
    way = 0.9 * way + 0.1 * Vec3d(number(), number(), number());
    samples.push_back((samples.back() + way).normalized());
  }
  return samples;
}

TEST(Front, GivesTheSameBitsInSeveralParts) {
  const unsigned seed = 8;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const Surface surface = make_surface(test::shuffled(test::sphere(5, 0.3, 1), 2));
  const Picker picker(surface);
  const ChartGround ground(surface);
  Front whole(ground), cut(ground);
  std::size_t nodes = 0, sheets = 0;
  for (int i = 0; i < 60; ++i) {
    const double radius = 0.1 + 0.1 * (i % 3);
    const SurfaceCurve curve = test::traced(surface, picker, radius, random_samples(random));
    whole.restart(radius, 2 - i % 2);
    whole.update(curve);
    const std::vector<Placed> expected = placed(whole);
    for (const std::size_t parts : {2u, 3u, 5u}) {
      cut.restart(radius, 2 - i % 2);
      cut.update(curve, 0, parts);
      const std::vector<Placed> found = placed(cut);
      ASSERT_EQ(found.size(), expected.size()) << parts << " parts, stroke " << i;
      ASSERT_TRUE(found == expected) << parts << " parts, stroke " << i;
    }
    nodes += expected.size();
    for (std::size_t n = 1; n < expected.size(); ++n) sheets += expected[n].vertex == expected[n - 1].vertex;
  }
  std::cout << nodes << " nodes, " << sheets << " of them second sheets\n";
  EXPECT_GT(nodes, 60000u);
  EXPECT_GT(sheets, 3000u);
}

TEST(Front, GrowsToTheSameBitsInSeveralParts) {
  std::mt19937 random(9);
  const Surface surface = make_surface(test::sphere(5, 0.3, 3));
  const Picker picker(surface);
  const ChartGround ground(surface);
  Front fresh(ground), growing(ground);
  constexpr double radius = 0.15;
  growing.restart(radius, 2);
  const std::vector<Vec3d> samples = random_samples(random);
  for (std::size_t count = 2; count <= samples.size(); ++count) {
    const SurfaceCurve curve =
        test::traced(surface, picker, radius, {samples.begin(), samples.begin() + static_cast<long>(count)});
    growing.update(curve, 0, 3);
    fresh.restart(radius, 2);
    fresh.update(curve);
    ASSERT_TRUE(placed(growing) == placed(fresh)) << count;
  }
}

}  // namespace
}  // namespace burin
