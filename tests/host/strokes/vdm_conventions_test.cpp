// Tests vector displacement maps in the conventions of different programs, drawn by the vdm-trail brush.

#include <burin/stamp/float_image.h>

#include <array>
#include <cmath>
#include <functional>

#include "host/sessions.h"
#include "support/shared_data.h"

namespace burin {
namespace {

using Texel = std::array<float, 3>;

/// A dune that leans to the right and up on the image: x, y to -1..1 within a square, 0 from a circle on.
Texel dune(double x, double y) {
  const double far = std::min(1.0, x * x + y * y), height = (1 - far) * (1 - far);
  return {static_cast<float>(0.3 * height * (1 + 0.5 * y)), static_cast<float>(0.2 * height),
          static_cast<float>(0.5 * height)};
}

void write_map(const std::filesystem::path& path, int width, int height,
               const std::function<Texel(double x, double y)>& texel) {
  FloatImage image{width, height, {"R", "G", "B"}, {}};
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      for (const float value : texel((2 * column + 1.0 - width) / height, (height - 2 * row - 1.0) / height))
        image.texels.push_back(value);
  write_exr(path, image);
}

/// The plane with a straight stroke of this brush on it, drawn with the map and other settings.
std::vector<Vec3f> drawn(const std::filesystem::path& map, const ParamSettings& params) {
  Session session(make_surface(test::plane(1, 0.02, 3)), test::brushes());
  StrokeSettings trail = test::settings("org.burin.vdm-trail", 0.2);
  trail.params = params;
  trail.params["stamp"] = map.string();
  session.begin_stroke(trail);
  for (int i = 0; i <= 100; ++i) session.add_sample({-0.7 + 0.014 * i, 0.05, 0}, 0.01 * i, {}, Show::later);
  session.end_stroke();
  return {session.positions().begin(), session.positions().end()};
}

void expect_equal(const std::vector<Vec3f>& found, const std::vector<Vec3f>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  float highest = 0, off = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    highest = std::max(highest, std::abs(expected[i].z()));
    off = std::max(off, (found[i] - expected[i]).norm());
  }
  EXPECT_GT(highest, 0.05f);
  EXPECT_LT(off, 1e-6f);
}

class VdmConventions : public ::testing::Test {
 protected:
  void SetUp() override {
    write_map(map_, 32, 32, dune);
    plain_ = drawn(map_, {});
  }

  test::TemporaryFolder folder_;
  const std::filesystem::path map_ = folder_.path() / "plain.exr", other_ = folder_.path() / "other.exr";
  std::vector<Vec3f> plain_;
};

TEST_F(VdmConventions, ReadsChannelsByTheAxesThatTheyHold) {
  const auto upright_green = [](double x, double y) -> Texel {
    const Texel d = dune(x, y);
    return {d[0], d[2], d[1]};
  };
  write_map(other_, 32, 32, upright_green);
  expect_equal(drawn(other_, {{"axes", "x,z,y"}}), plain_);
  expect_equal(drawn(other_, {{"axes", "cycles"}}), plain_);
  expect_equal(drawn(map_, {{"axes", "blender"}}), plain_);
  const auto turned = [](double x, double y) -> Texel {
    const Texel d = dune(x, y);
    return {-d[2], d[0], -d[1]};
  };
  write_map(other_, 32, 32, turned);
  expect_equal(drawn(other_, {{"axes", "-z,x,-y"}}), plain_);
}

TEST_F(VdmConventions, MovesNothingWhereTheMapHasItsMiddle) {
  const auto signed_half = [](double x, double y) -> Texel {
    const Texel d = dune(x, y);
    return {0.5f + d[0] / 2, 0.5f + d[1] / 2, 0.5f + d[2] / 2};
  };
  write_map(other_, 32, 32, signed_half);
  // There is no displacement outside the image between stamps either.
  expect_equal(drawn(other_, {{"middle", 0.5}, {"amount", 2.0}, {"gap", 1.0}}), drawn(map_, {{"gap", 1.0}}));
}

TEST_F(VdmConventions, KeepsTheAspectOfTheMap) {
  write_map(other_, 64, 32, dune);  // as wide again, with nothing left and right of the dune
  expect_equal(drawn(other_, {}), drawn(map_, {{"gap", 2.0}}));
}

TEST_F(VdmConventions, RefusesOtherAxes) {
  for (const char* axes : {"x,y", "x,y,y", "maya"})
    EXPECT_THROW(drawn(map_, {{"axes", axes}}), Error) << axes;
}

TEST_F(VdmConventions, TakesTheLayerThatIsAskedFor) {
  write_exr(other_, {1, 1, {"a.B", "a.G", "a.R", "b.B", "b.G", "b.R"}, {0.5f, 0, 0, 0.25f, 0, 0}});
  EXPECT_THROW(drawn(other_, {}), Error);
  const auto highest = [&](const ParamSettings& params) {
    float z = 0;
    for (const Vec3f& position : drawn(other_, params)) z = std::max(z, position.z());
    return z;
  };
  EXPECT_NEAR(highest({{"layer", "a"}}), 0.1f, 2e-3f);
  EXPECT_NEAR(highest({{"layer", "b"}}), 0.05f, 2e-3f);
  EXPECT_NEAR(highest({{"channel", "b.R,b.G,a.B"}}), 0.1f, 2e-3f);
}

}  // namespace
}  // namespace burin
