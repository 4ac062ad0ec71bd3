#include <algorithm>
#include <cmath>
#include <numbers>

#include "ink_brush.h"

namespace burin {
namespace {

enum Figure { dots, diamonds, triangles, waves, chain };

/// Figures of length 1.8 in a row of spacing 2, half as wide as 0.6.
class PatternedLine : public test::InkBrush {
 protected:
  PatternedLine() : InkBrush("brushes/patterned_line", "org.burin.patterned-line") {
    stroke_.params.set("spacing", 2);
    stroke_.params.set("fill", 0.9f);
    stroke_.params.set("width", 0.6f);
    stroke_.params.set("line", 0.25f);
  }

  /// Whether `inside` says so of the place seen from the middle of one of the stroke's five figures.
  template <class Inside>
  void expect_row(float figure, const Inside& inside) {
    SCOPED_TRACE(figure);
    stroke_.params.set("figure", figure);
    expect_inside([&](double t, double d) {
      for (double middle = 1; middle < 10; middle += 2)
        if (inside(t - middle, d)) return true;
      return false;
    });
  }
};

TEST_F(PatternedLine, DrawsDots) {
  expect_row(dots, [](double x, double y) { return std::hypot(x, y) < 0.6; });
}

TEST_F(PatternedLine, DrawsDiamonds) {
  expect_row(diamonds, [](double x, double y) { return std::abs(x) / 0.9 + std::abs(y) / 0.6 < 1; });
}

TEST_F(PatternedLine, DrawsTrianglesThatPointForward) {
  expect_row(triangles, [](double x, double y) { return x > -0.9 && std::abs(y) < 0.6 * (0.9 - x) / 1.8; });
}

TEST_F(PatternedLine, DrawsWavesOfEvenThickness) {
  stroke_.params.set("figure", waves);
  constexpr double amplitude = 0.6 - 0.075, k = std::numbers::pi;
  test::Nodes nodes;
  std::vector<bool> expected;
  for (double t = 0.02; t < 9.98; t += 0.037) {
    const double x = t - 1, y = amplitude * std::sin(k * x), slope = amplitude * k * std::cos(k * x);
    const double length = std::hypot(1, slope);
    for (const double off : {-0.1, -0.05, 0.0, 0.05, 0.1}) {  // along the curve's normal
      nodes.t.push_back(static_cast<float>(t - off * slope / length));
      nodes.d.push_back(static_cast<float>(y + off / length));
      expected.push_back(std::abs(off) < 0.075);
    }
  }
  const std::vector<float> shares = covered(nodes);
  for (std::size_t i = 0; i < shares.size(); ++i)
    EXPECT_EQ(shares[i] > 0.5f, expected[i]) << nodes.t[i] << ' ' << nodes.d[i];
}

TEST_F(PatternedLine, DrawsLinksThatHoldEachOther) {
  expect_row(chain, [](double x, double y) {
    const double ring = std::hypot(std::max(std::abs(x) - 0.1, 0.0), y);
    const double bar = std::hypot(std::max(std::abs(std::abs(x) - 1) - 0.425, 0.0), y);
    return (ring < 0.6 && ring > 0.45) || (bar < 0.075 && std::abs(x) <= 1.075);
  });
  EXPECT_EQ(covered(2, 0), 1) << "a bar joins two rings";
  EXPECT_EQ(covered(1, 0), 0) << "a ring is open";
}

TEST_F(PatternedLine, DrawsWholeFiguresOnly) {
  stroke_.params.set("figure", dots);
  stroke_.context.length = 9.9;
  EXPECT_EQ(covered(7, 0), 1);
  EXPECT_EQ(covered(9, 0), 0);
  EXPECT_EQ(covered(-1, 0), 0);
  stroke_.context.length = 0;
  EXPECT_EQ(covered(1, 0), 1) << "but one always";
  stroke_.context.length = 9;
  stroke_.context.flags |= BURIN_STROKE_CLOSED;  // 9 / 2: five of 1.8
  for (float t = 0.9f; t < 9; t += 1.8f) {
    EXPECT_EQ(covered(t, 0), 1) << t;
    EXPECT_EQ(covered(t + 0.9f, 0), 0) << t;
  }
}

TEST_F(PatternedLine, SharesOutCellsAtTheBordersOfFigures) {
  stroke_.params.set("fill", 1);
  for (const float figure : {diamonds, triangles}) {
    stroke_.params.set("figure", figure);
    for (const float cell : {0.02f, 0.05f}) EXPECT_NEAR(mean_covered(0, 10, cell), 0.3, 0.006) << figure;
  }
}

}  // namespace
}  // namespace burin
