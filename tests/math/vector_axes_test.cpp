#include <burin/math/vector_axes.h>
#include <gtest/gtest.h>

namespace burin::math {
namespace {

TEST(VectorAxes, ReadsEveryOrderAndSign) {
  int read = 0;
  for (const char* order : {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx"})
    for (int signs = 0; signs < 8; ++signs) {
      std::string text;
      for (int channel = 0; channel < 3; ++channel)
        text += std::string(channel ? "," : "") + (signs >> channel & 1 ? "-" : "") + order[channel];
      const auto axes = vector_axes(text);
      ASSERT_TRUE(axes) << text;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(order[axes->channel[axis]], static_cast<char>('x' + axis)) << text;
        EXPECT_EQ(axes->sign[axis] < 0, (signs >> axes->channel[axis] & 1) != 0) << text;
      }
      ++read;
    }
  EXPECT_EQ(read, 48);
}

TEST(VectorAxes, KnowsPrograms) {
  EXPECT_EQ(vector_axes("blender")->channel, vector_axes("x,y,z")->channel);
  EXPECT_EQ(vector_axes("cycles")->channel, vector_axes("x,z,y")->channel);
  EXPECT_EQ(vector_axes("mudbox")->channel, vector_axes("x,z,y")->channel);
}

TEST(VectorAxes, RefusesOtherTexts) {
  for (const char* text :
       {"", "x", "x,y", "x,y,z,", "x,y,y", "x y z", "X,Y,Z", "x,y,w", "--x,y,z", "x,y,-", "maya"})
    EXPECT_FALSE(vector_axes(text)) << text;
}

}  // namespace
}  // namespace burin::math
