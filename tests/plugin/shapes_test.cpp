#include <burin/plugin/shapes.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <random>
#include <vector>

namespace burin::plugin {
namespace {

using Figure = std::function<float(Point)>;
using Inside = std::function<bool(Point)>;

/// Checks a distance against the figure's definition: its sign, and that as far as it says, and no farther,
/// all places around are on the same side.
void expect_distance(const Figure& figure, const Inside& inside, bool exact_outside = true) {
  const unsigned seed = std::random_device{}();
  std::cout << "seed " << seed << '\n';
  std::mt19937 engine(seed);
  std::uniform_real_distribution<float> any(-2, 2);
  int within = 0;
  for (int i = 0; i < 400; ++i) {
    const Point p{any(engine), any(engine)};
    const float distance = figure(p);
    if (std::abs(distance) < 1e-3f) continue;
    ASSERT_EQ(distance < 0, inside(p)) << p.x << ' ' << p.y;
    within += inside(p);
    int crossings = 0;
    for (int k = 0; k < 720; ++k) {
      const float angle = static_cast<float>(k) * 0.0087266f, reach = std::abs(distance);
      const auto at = [&](float r) { return Point{p.x + r * std::cos(angle), p.y + r * std::sin(angle)}; };
      ASSERT_EQ(inside(at(0.999f * reach)), inside(p)) << p.x << ' ' << p.y << ' ' << k;
      crossings += inside(at(1.02f * reach + 2e-3f)) != inside(p);
    }
    if (exact_outside || distance < 0) {
      EXPECT_GT(crossings, 0) << "farther than needed at " << p.x << ' ' << p.y;
    }
  }
  EXPECT_GT(within, 10);
}

TEST(Shapes, Circle) {
  expect_distance([](Point p) { return circle(p, 0.8f); },
                  [](Point p) { return std::hypot(p.x, p.y) < 0.8f; });
}

TEST(Shapes, Box) {
  expect_distance([](Point p) { return box(p, 0.9f, 0.5f); },
                  [](Point p) { return std::abs(p.x) < 0.9f && std::abs(p.y) < 0.5f; });
}

TEST(Shapes, Bar) {
  expect_distance([](Point p) { return bar(p, 1.3f, 0.5f); },
                  [](Point p) { return p.x > 0 && p.x < 1.3f && std::abs(p.y) < 0.5f; });
}

TEST(Shapes, Capsule) {
  expect_distance([](Point p) { return capsule(p, 0.6f, 0.5f); },
                  [](Point p) { return std::hypot(p.x - std::clamp(p.x, -0.6f, 0.6f), p.y) < 0.5f; });
}

TEST(Shapes, Diamond) {
  expect_distance([](Point p) { return diamond(p, 1.2f, 0.6f); },
                  [](Point p) { return std::abs(p.x) / 1.2f + std::abs(p.y) / 0.6f < 1; });
}

TEST(Shapes, Triangle) {
  expect_distance([](Point p) { return triangle(p, 1.5f, 0.7f); },
                  [](Point p) { return p.x > 0 && std::abs(p.y) < 0.7f * (1 - p.x / 1.5f); });
}

TEST(Shapes, Hexagon) {
  const auto inside = [](Point p) {
    for (const float degrees : {0.0f, 60.0f, 120.0f}) {
      const float angle = degrees / 57.29578f;
      if (std::abs(p.x * std::cos(angle) + p.y * std::sin(angle)) >= 0.9f) return false;
    }
    return true;
  };
  expect_distance([](Point p) { return hexagon(p, 0.9f); }, inside, false);
}

TEST(Shapes, JoinCutAndOutline) {
  const auto ring = [](Point p) { return outline(circle(p, 1), 0.3f); };
  expect_distance(ring, [](Point p) {
    const float r = std::hypot(p.x, p.y);
    return r < 1 && r > 0.7f;
  });
  const auto half = [](Point p) { return cut(circle(p, 1), p.x); };
  expect_distance(
      half, [](Point p) { return std::hypot(p.x, p.y) < 1 && p.x < 0; }, false);
  const Point right{0.9f, 0};
  EXPECT_FLOAT_EQ(join(circle(right, 0.5f), circle(right - Point{1, 0}, 0.2f)), -0.1f);
}

TEST(Coverage, IsTheShareOfACellBeyondAStraightOutline) {
  EXPECT_EQ(coverage(0, 0.2f), 0.5f);
  EXPECT_FLOAT_EQ(coverage(-0.05f, 0.2f), 0.75f);
  EXPECT_EQ(coverage(-0.1f, 0.2f), 1);
  EXPECT_EQ(coverage(0.1f, 0.2f), 0);
  EXPECT_EQ(coverage(1e-6f, 0), 0) << "without a footprint a hard edge";
  EXPECT_EQ(coverage(-1e-6f, 0), 1);
}

}  // namespace
}  // namespace burin::plugin
