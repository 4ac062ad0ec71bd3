#include <cmath>

#include "ink_brush.h"

namespace burin {
namespace {

enum FillPattern { hatch, cross_hatch, checker, fill_dots, hexagons };

class PatternedFill : public test::InkBrush {
 protected:
  PatternedFill() : InkBrush("brushes/patterned_fill", "org.burin.patterned-fill") {
    stroke_.params.set("cell", cell);
    stroke_.params.set("fill", 0.6f);
    stroke_.params.set("width", 0.8f);
    stroke_.params.set("border", 0);
  }

  static bool in_band(double t, double d) { return std::hypot(std::max({-t, t - 10, 0.0}), d) < 0.8; }

  template <class Inside>
  void expect_pattern(float pattern, const Inside& inside) {
    SCOPED_TRACE(pattern);
    stroke_.params.set("pattern", pattern);
    expect_inside([&](double t, double d) { return in_band(t, d) && inside(t / cell, d / cell); });
  }

  static constexpr float cell = 0.4f;
};

double to_whole(double x) { return std::abs(x - std::round(x)); }

TEST_F(PatternedFill, HatchesAtFortyFiveDegrees) {
  expect_pattern(hatch, [](double x, double y) { return to_whole(x + y) < 0.3; });
  expect_pattern(cross_hatch,
                 [](double x, double y) { return to_whole(x + y) < 0.3 || to_whole(x - y) < 0.3; });
}

TEST_F(PatternedFill, ChecksEverySecondSquare) {
  expect_pattern(checker, [](double x, double y) {
    const auto square = [](double c) { return static_cast<int>(std::floor(2 * (c + 0.25))); };
    return (square(x) + square(y)) % 2 == 0;
  });
}

/// Whether a figure of the staggered rows around holds (x, y).
template <class Inside>
bool in_rows(double x, double y, double pitch, const Inside& inside) {
  for (int row = -6; row <= 6; ++row)
    for (int column = -5; column <= 35; ++column)
      if (inside(x - column - (row % 2 ? 0.5 : 0), y - row * pitch)) return true;
  return false;
}

TEST_F(PatternedFill, PacksDotsAndHexagons) {
  expect_pattern(fill_dots, [](double x, double y) {
    return in_rows(x, y, 0.5, [](double u, double v) { return std::hypot(u, v) < 0.3; });
  });
  expect_pattern(hexagons, [](double x, double y) {
    return in_rows(x, y, std::sqrt(0.75), [](double u, double v) {
      return std::abs(u) < 0.3 && std::abs(u) / 2 + std::sqrt(0.75) * std::abs(v) < 0.3;
    });
  });
}

TEST_F(PatternedFill, DrawsAnOutlineAroundTheBand) {
  stroke_.params.set("border", 0.1f);
  stroke_.params.set("pattern", fill_dots);
  stroke_.params.set("fill", 0.01f);
  expect_inside([&](double t, double d) {
    const double distance = std::hypot(std::max({-t, t - 10, 0.0}), d);
    const bool dot =
        in_rows(t / cell, d / cell, 0.5, [](double u, double v) { return std::hypot(u, v) < 0.005; });
    return (distance > 0.7 && distance < 0.8) || (dot && distance < 0.8);
  });
}

TEST_F(PatternedFill, TakesWholeCellsAroundALoop) {
  stroke_.params.set("cell", 0.45f);  // 10 / 0.45: 22 cells
  stroke_.context.flags |= BURIN_STROKE_CLOSED;
  for (const float pattern : {hatch, cross_hatch, checker, fill_dots, hexagons}) {
    stroke_.params.set("pattern", pattern);
    test::Nodes nodes, further;
    for (float d = -0.75f; d < 0.8f; d += 0.0503f)
      for (const float t : {0.0313f, 0.2017f, 0.3501f}) {
        nodes.t.push_back(t);
        further.t.push_back(t + 10 * 10.0f / 22);
        nodes.d.push_back(d);
        further.d.push_back(d);
      }
    const std::vector<float> here = covered(nodes, 0.05f), there = covered(further, 0.05f);
    for (std::size_t i = 0; i < here.size(); ++i) EXPECT_NEAR(here[i], there[i], 2e-4) << pattern;
    const std::vector<float> seam = covered({{0, 0}, {0.21f, -0.4f}}, 0.05f),
                             round = covered({{10, 10}, {0.21f, -0.4f}}, 0.05f);
    for (std::size_t i = 0; i < seam.size(); ++i) EXPECT_NEAR(seam[i], round[i], 2e-4) << pattern;
  }
}

TEST_F(PatternedFill, CoversAsMuchHoweverCoarseTheMesh) {
  stroke_.params.set("width", 1);
  for (const auto& [pattern, share] : {std::pair{hatch, 0.6}, {checker, 0.5}}) {
    stroke_.params.set("pattern", static_cast<float>(pattern));
    for (const float size : {0.01f, 0.04f}) EXPECT_NEAR(mean_covered(2, 8, size), share, 0.03 * share);
  }
}

}  // namespace
}  // namespace burin
