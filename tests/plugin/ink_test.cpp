#include <burin/plugin/falloff.h>

#include <cmath>

#include "plugin/brushes/ink_brush.h"

namespace burin {
namespace {

/// Ink by way of a straight butt dash that is longer than the stroke: its outline is at d = +-0.5.
class Ink : public test::InkBrush {
 protected:
  Ink() : InkBrush("brushes/dashed_line", "org.burin.dashed-line") {
    stroke_.params.set("dash", 100);
    stroke_.params.set("gap", 0);
    stroke_.params.set("width", 0.5f);
    stroke_.params.set("caps", 1);
    stroke_.params.set("bevel", 0.2f);
    stroke_.params.set("height", 0.3f);
    stroke_.params.set("mask", 0);
  }

  void set_colour(float r, float g, float b, float a) {
    colour_ = {r, g, b, a};
    for (std::size_t i = 0; i < 4; ++i) stroke_.params.value("colour").colour[i] = {&colour_[i], 0, 0};
  }

  std::array<float, 4> colour_{};
};

TEST_F(Ink, RisesFromTheOutlineInward) {
  EXPECT_EQ(covered(test::Nodes{{5, 5, 5, 5, 5}, {0, 0.25f, 0.4f, 0.5f, 0.6f}}).size(), 5u);
  EXPECT_EQ(stroke_.up[0], 0.3f);
  EXPECT_EQ(stroke_.up[1], 0.3f);
  EXPECT_NEAR(stroke_.up[2], 0.15f, 1e-6);
  EXPECT_EQ(stroke_.up[3], 0);
  EXPECT_EQ(stroke_.up[4], 0);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(stroke_.along[i], 0);
    EXPECT_EQ(stroke_.across[i], 0);
  }
}

TEST_F(Ink, IsNoSteeperThanTheMeshCanShow) {
  covered({{5}, {0.3f}}, 0.4f);
  EXPECT_NEAR(stroke_.up[0], 0.15f, 1e-6) << "half of the height at half of a cell within";
}

TEST_F(Ink, LeavesColourAndMaskAloneByDefault) {
  stroke_.mask_before = 0.7f;
  stroke_.colour_before = {0.1f, 0.2f, 0.3f, 0.4f};
  covered(5, 0);
  EXPECT_EQ(stroke_.mask[0], 0.7f);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(stroke_.colour[i][0], stroke_.colour_before[i]);
}

TEST_F(Ink, ProtectsWhatItCovers) {
  stroke_.params.set("mask", 0.75f);
  stroke_.mask_before = 0.8f;
  covered({{5, 5, 5}, {0, 0.5f, 0.9f}}, 0.1f);
  EXPECT_FLOAT_EQ(stroke_.mask[0], 0.2f);
  EXPECT_FLOAT_EQ(stroke_.mask[1], 0.8f * (1 - 0.375f));
  EXPECT_EQ(stroke_.mask[2], 0.8f);
}

TEST_F(Ink, LaysItsColourOverWhatIsThere) {
  set_colour(1, 0.5f, 0, 0.5f);
  stroke_.colour_before = {0, 0.5f, 1, 1};
  covered(test::Nodes{{5, 5}, {0, 0.9f}});
  const float over[] = {0.5f, 0.5f, 0.5f, 1};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_FLOAT_EQ(stroke_.colour[i][0], over[i]) << i;
    EXPECT_EQ(stroke_.colour[i][1], stroke_.colour_before[i]) << i;
  }
  stroke_.colour_before = {0.9f, 0.9f, 0.9f, 0};  // nothing there yet
  covered(5, 0);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_FLOAT_EQ(stroke_.colour[i][0], colour_[i]) << i;
}

}  // namespace
}  // namespace burin
