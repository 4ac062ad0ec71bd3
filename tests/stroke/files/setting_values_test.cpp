#include <burin/base/text/json_value.h>
#include <burin/stroke/files/setting_values.h>
#include <gtest/gtest.h>

#include <string>

#include "support/error_of.h"

namespace burin {
namespace {

JsonValue text(const std::string& value) { return JsonValue::parse('"' + value + '"', "here"); }

TEST(ReadAxes, TakesTwoAxesAtRightAngles) {
  AlongSettings along;
  read_axes(text("-z,y"), along);
  EXPECT_EQ(along.forward, Vec3d(0, 0, -1));
  EXPECT_EQ(along.up, Vec3d(0, 1, 0));
  for (const char* bad : {"x,x", "x,-x", "x", "x,", ",y", "x,w", "x,yz", ""})
    EXPECT_EQ(test::error_of([&] { read_axes(text(bad), along); }),
              "here: must be two axes such as x,y or -z,y, not '" + std::string(bad) + "'");
}

TEST(ReadMirrors, SetsThoseThatAreNamed) {
  for (const std::string axes : {"x", "y", "z", "xz", "zyx"}) {
    Symmetry symmetry;
    read_mirrors(text(axes), symmetry);
    EXPECT_EQ(symmetry.mirror_x, axes.find('x') != std::string::npos) << axes;
    EXPECT_EQ(symmetry.mirror_y, axes.find('y') != std::string::npos) << axes;
    EXPECT_EQ(symmetry.mirror_z, axes.find('z') != std::string::npos) << axes;
  }
}

TEST(ReadStabilising, TakesAKindAndAnAmountAbove0) {
  EXPECT_EQ(read_stabilising(text("string:0.5")).kind, Stabilising::Kind::string);
  EXPECT_EQ(read_stabilising(text("exponential:0.25")).kind, Stabilising::Kind::exponential);
  EXPECT_EQ(read_stabilising(text("exponential:0.25")).amount, 0.25);
  for (const char* bad : {"string:0", "string:-1", "string:inf", "string:1e999", "string:1 ",
                          "string:", "string", "rope:1", ""})
    EXPECT_EQ(test::error_of([&] { read_stabilising(text(bad)); }),
              "here: must be string:LENGTH or exponential:SECONDS, above 0, not '" + std::string(bad) + "'");
}

}  // namespace
}  // namespace burin
