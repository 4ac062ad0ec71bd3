#include <cmath>
#include <numbers>

#include "stock_brush.h"

namespace burin {
namespace {

using test::Nodes;
using test::steps;

constexpr double pi = std::numbers::pi;
enum Lay { twisted, plaited };

/// The circles of a rope of half width 1.
struct Strands {
  explicit Strands(int count)
      : thickness((count == 2 ? 1 : std::sin(pi / 3)) * orbit_of(count)), orbit(orbit_of(count)) {}
  double thickness, orbit;

 private:
  static double orbit_of(int count) { return 1 / (1 + (count == 2 ? 1 : std::sin(pi / 3)) / 0.9); }
};

class Rope : public test::StockBrush {
 protected:
  Rope() : StockBrush("rope") {
    stroke_.params.set("width", 1);
    stroke_.params.set("turn", 4);
  }

  /// How often along `turns` turns of a strand it goes from the top to below another one. `lift`: height of
  /// its middle by its angle.
  template <class Lift>
  int dives(int strands, int turns, const Lift& lift) {
    const Strands rope(strands);
    Nodes nodes;
    for (const float t : steps(4000, 4.0f * static_cast<float>(turns))) {
      nodes.t.push_back(t);
      nodes.d.push_back(static_cast<float>(rope.orbit * std::sin(pi * t / 2)));
    }
    const auto up = evaluate(nodes).up;
    int count = 0;
    bool below = false;
    for (std::size_t i = 0; i < up.size(); ++i) {
      const double top = lift(pi * nodes.t[i] / 2) * rope.orbit + rope.thickness;
      EXPECT_GE(up[i], top - 1e-5) << "a strand is at least as high as itself";
      count += up[i] > top + 0.02 && !below;
      below = up[i] > top + 0.02;
    }
    return count;
  }
};

TEST_F(Rope, HasAStrandOnTopWhereStrandsCross) {
  for (const int strands : {2, 3}) {
    stroke_.params.set("strands", static_cast<float>(strands));
    const Strands rope(strands);
    for (int crossing = 0; crossing < strands; ++crossing)
      EXPECT_NEAR(at(4.0f * static_cast<float>(crossing) / static_cast<float>(strands), 0).z,
                  rope.orbit + rope.thickness, 1e-5)
          << strands;
  }
}

TEST_F(Rope, TakesTurnsOverAndUnder) {
  stroke_.params.set("strands", 2);
  EXPECT_EQ(dives(2, 2, [](double angle) { return std::cos(angle); }), 2);
  stroke_.params.set("strands", 3);
  EXPECT_EQ(dives(3, 2, [](double angle) { return std::cos(angle); }), 2);
  stroke_.params.set("lay", plaited);
  EXPECT_EQ(dives(3, 2, [](double angle) { return std::sin(2 * angle) / 2; }), 4)
      << "a strand of a plait passes below one on either side";
}

TEST_F(Rope, TurnsToTheOtherHandWhenMirrored) {
  // Strands of a right-handed helix run from lower left to upper right: rising d along t on top.
  const float ahead = at(0.3f, 0.25f).z, behind = at(0.3f, -0.25f).z;
  EXPECT_GT(ahead, behind + 0.05f);
}

TEST_F(Rope, FitsWholeTurnsIntoALoop) {
  for (const float lay : {twisted, plaited}) {
    stroke_.params.set("lay", lay);
    for (const float strands : {2.0f, 3.0f}) {
      stroke_.params.set("strands", strands);
      expect_closed_seam();
    }
  }
  EXPECT_NEAR(at(0, 0.1f).z, at(1.9f, 0.1f).z, 1e-5f);
}

TEST_F(Rope, HasNoStep) {
  expect_no_step(7);
  stroke_.params.set("lay", plaited);
  expect_no_step(7);
}
TEST_F(Rope, GrowsWithTheStroke) { expect_scale_invariance(); }
TEST_F(Rope, IsFiniteEverywhere) { expect_finite(); }

}  // namespace
}  // namespace burin
