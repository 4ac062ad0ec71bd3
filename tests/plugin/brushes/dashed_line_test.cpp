#include <algorithm>
#include <cmath>

#include "ink_brush.h"

namespace burin {
namespace {

enum Caps { round_caps, butt_caps };

class DashedLine : public test::InkBrush {
 protected:
  DashedLine() : InkBrush("brushes/dashed_line", "org.burin.dashed-line") {
    stroke_.params.set("dash", 1.5f);
    stroke_.params.set("gap", 0.7f);
    stroke_.params.set("width", 0.3f);
  }

  static bool in_a_dash(Caps caps, double t, double d) {
    for (double from = 0; from < 10; from += 1.5f + 0.7f) {
      const double to = std::min(from + 1.5, 10.0), cap = caps == round_caps ? 0.3 : 0;
      const double middle = (from + to) / 2, core = std::max((to - from) / 2 - cap, 0.0);
      const double beyond = std::max(std::abs(t - middle) - core, 0.0);
      if (caps == round_caps ? std::hypot(beyond, d) <= 0.3 : beyond == 0 && std::abs(d) <= 0.3) return true;
    }
    return false;
  }
};

TEST_F(DashedLine, DrawsDashesOfBothCaps) {
  for (const Caps caps : {round_caps, butt_caps}) {
    SCOPED_TRACE(caps);
    stroke_.params.set("caps", static_cast<float>(caps));
    expect_inside([&](double t, double d) { return in_a_dash(caps, t, d); });
  }
}

TEST_F(DashedLine, CoversAsMuchHoweverCoarseTheMesh) {
  stroke_.params.set("caps", butt_caps);
  const double dashes = (4 * 1.5 + 1.2) * 0.6 / 20;  // of 0, 2.2, 4.4, 6.6 and the cut one at 8.8
  for (const float cell : {0.02f, 0.05f, 0.1f}) EXPECT_NEAR(mean_covered(0, 10, cell), dashes, 0.01 * dashes);
}

TEST_F(DashedLine, TakesWholeDashesAroundALoop) {
  stroke_.context.flags |= BURIN_STROKE_CLOSED;  // 10 / 2.2: five periods of 2
  for (float t = 0.013f; t < 10; t += 0.11f)
    EXPECT_EQ(covered(t, 0.1f), covered(t < 8 ? t + 2 : t - 8, 0.1f)) << t;
  EXPECT_EQ(covered(0.7f, 0), 1);
  EXPECT_EQ(covered(1.7f, 0), 0);
  EXPECT_EQ(covered(9.99f, 0.1f), covered(-0.01f, 0.1f)) << "one place by two names";
}

TEST_F(DashedLine, NarrowsWithTheStroke) {
  EXPECT_EQ(covered(0.75f, 0.25f), 1);
  test::Nodes narrow{{0.75f, 0.75f}, {0.25f, 0.1f}};
  narrow.radius = 0.5f;
  EXPECT_EQ(covered(narrow), (std::vector<float>{0, 1}));
}

TEST_F(DashedLine, GoesOnThroughTheDabsOfALine) {
  const std::vector<float> t{-0.9f, -0.3f, 0, 0.3f, 0.9f}, d{0, 0.1f, 0.2f, 0.1f, 0};
  std::vector<float> on_line;
  for (const float x : t) on_line.push_back(3.1f + x);
  const std::vector<float> line = covered({on_line, d});
  stroke_.context.flags |= BURIN_STROKE_DAB;
  stroke_.context.length = 0;
  stroke_.context.dab_t = 3.1f;
  EXPECT_EQ(covered({t, d}), line);
  EXPECT_NE(std::count(line.begin(), line.end(), 1.0f), 0);
  EXPECT_NE(std::count(line.begin(), line.end(), 0.0f), 0);
}

TEST_F(DashedLine, IsADotWhereThePenHasNotMoved) {
  stroke_.context.length = 0;
  EXPECT_EQ(covered(0, 0.2f), 1);
  EXPECT_EQ(covered(0.2f, -0.1f), 1);
  EXPECT_EQ(covered(0.4f, 0), 0);
}

}  // namespace
}  // namespace burin
