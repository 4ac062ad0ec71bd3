#include <burin/base/error.h>
#include <burin/deform/evaluate/param_dynamics.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "deform/varying_brush.h"

namespace burin {
namespace {

using test::VaryingBrush;

const DrivenStroke driven_stroke{.fields = {.pressure = true}, .radius = 1, .seed = 0};

PenAt pressed(float pressure) {
  PenAt at;
  at.pen.pressure = pressure;
  return at;
}

/// Value of the only parameter that varies.
float value(const std::string& target, const std::vector<double>& curve, float pressure) {
  const VaryingBrush brush;
  const std::vector<Dynamic> dynamics{{target, PenSource::pressure, curve}};
  const ParamDynamics driven(brush.descriptor, brush.params, dynamics, driven_stroke);
  EXPECT_EQ(driven.params().size(), 1u);
  EXPECT_EQ(driven.strength(pressed(pressure), 0), 1);
  return ParamDynamics::value(driven.params().at(0), pressed(pressure), 0);
}

TEST(ParamDynamics, MultiplyNumbersAndAddToAngles) {
  EXPECT_FLOAT_EQ(value("size", {0, 0, 1, 1}, 0.25F), 0.5F);
  EXPECT_FLOAT_EQ(value("turn", {0, 0, 1, 1}, 0.25F), 0.75F);
  EXPECT_FLOAT_EQ(value("turn", {0, -1, 1, 1}, 0.25F), 0);
}

TEST(ParamDynamics, StayWithinTheHardRangeAndWhole) {
  EXPECT_EQ(value("size", {0, 0, 1, 1000}, 1), 4);
  EXPECT_EQ(value("size", {0, -1, 1, 1}, 0), 0.125F);
  EXPECT_EQ(value("count", {0, 0, 1, 1}, 0.5F), 4) << "3.5 rounded";
  EXPECT_EQ(value("count", {0, 0, 1, 1}, 0), 1);
  EXPECT_EQ(value("flip", {0, 0, 1, 1}, 0.4F), 0);
  EXPECT_EQ(value("flip", {0, 0, 1, 9}, 0.9F), 1);
  EXPECT_EQ(value("endless", {0, 3e38}, 1), std::numeric_limits<float>::max());
}

TEST(ParamDynamics, TellWhatVaries) {
  const VaryingBrush brush;
  const auto of = [&](const std::vector<Dynamic>& dynamics) {
    return ParamDynamics(brush.descriptor, brush.params, dynamics, driven_stroke);
  };
  EXPECT_FALSE(of({}).any());
  EXPECT_FALSE(of({{"radius", PenSource::t, {0, 1}}}).any()) << "the curve's business";
  EXPECT_FALSE(of({{"size", PenSource::time, {0, 1}}}).any()) << "the recording has no time";
  const ParamDynamics strength = of({{"strength", PenSource::pressure, {0, 0, 1, 2}}});
  EXPECT_TRUE(strength.any());
  EXPECT_TRUE(strength.params().empty());
  EXPECT_EQ(strength.strength(pressed(0.25F), 0), 0.5F);
  const ParamDynamics two = of({{"turn", PenSource::t, {0, 1}},
                                {"size", PenSource::t, {0, 1}},
                                {"turn", PenSource::pressure, {0, 1}}});
  ASSERT_EQ(two.params().size(), 2u);
  EXPECT_EQ(two.params()[0].index, 0u);
  EXPECT_EQ(two.params()[1].index, 1u);
  EXPECT_EQ(ParamDynamics::value(two.params()[1], pressed(1), 0), 2.5F) << "both act";
}

TEST(ParamDynamics, RefuseWhatDoesNotVary) {
  const VaryingBrush brush;
  for (const char* target : {"fixed", "picture", "tint", "mode", "siz", ""}) {
    try {
      ParamDynamics(brush.descriptor, brush.params, std::vector<Dynamic>{{target, PenSource::time, {0, 1}}},
                    driven_stroke);
      ADD_FAILURE() << target;
    } catch (const Error& error) {
      EXPECT_EQ(error.what(), "dynamics of '" + std::string(target) +
                                  "': org.burin.test.varying has no such thing that varies along a stroke; "
                                  "there are: radius, strength, size, turn, count, flip, endless");
    }
  }
}

}  // namespace
}  // namespace burin
