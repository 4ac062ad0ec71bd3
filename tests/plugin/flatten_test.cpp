#include <algorithm>
#include <cmath>

#include "stock_brush.h"

namespace burin {
namespace {

using test::Nodes;
using test::Vector;

enum Part { both, peaks, valleys };

Vector unit(Vector v) {
  const float length = std::hypot(v.x, v.y, v.z);
  return {v.x / length, v.y / length, v.z / length};
}

class Flatten : public test::StockBrush {
 protected:
  Flatten() : StockBrush("flatten") {}

  /// Places around a plane that leans, with normals within a few degrees of the plane's; `height_` over it.
  void add_inputs(Nodes& nodes) override {
    const float r = nodes.radius;
    for (std::size_t i = 0; i < nodes.t.size(); ++i) {
      nodes.foot.push_back({3 * r, 2 * r, r});
      nodes.foot_normal.push_back(plane_);
      nodes.normal.push_back(unit({plane_.x + lean_, plane_.y - lean_, plane_.z}));
      const Vector on_plane{plane_.y, -plane_.x, 0};
      nodes.position.push_back({3 * r + r * (on_plane.x + height_ * plane_.x),
                                2 * r + r * (on_plane.y + height_ * plane_.y), r + r * height_ * plane_.z});
    }
  }

  /// Over the plane, after the brush.
  float height_after(const Nodes& nodes, float up) const {
    const Vector &p = nodes.position[0], &n = nodes.normal[0], &foot = nodes.foot[0];
    return (p.x + up * n.x - foot.x) * plane_.x + (p.y + up * n.y - foot.y) * plane_.y +
           (p.z + up * n.z - foot.z) * plane_.z;
  }

  const Vector plane_ = unit({1, 2, 3});
  float lean_ = 0.1f, height_ = 0.2f;
};

TEST_F(Flatten, ReachesThePlaneAlongTheNormal) {
  for (const float height : {0.3f, -0.3f, 0.01f}) {
    height_ = height;
    Nodes nodes{{5}, {0.1f}};
    add_inputs(nodes);
    ASSERT_NEAR(height_after(nodes, 0), height, 1e-6f);
    const test::Displaced moved = evaluate(nodes);
    EXPECT_NEAR(height_after(nodes, moved.up[0]), 0, 1e-6f);
    EXPECT_EQ(moved.along[0], 0);
    EXPECT_EQ(moved.across[0], 0);
  }
  stroke_.params.set("amount", 0.25f);
  Nodes nodes{{5}, {0}};
  add_inputs(nodes);
  EXPECT_NEAR(height_after(nodes, at(5, 0).z), 0.75f * height_, 1e-6f);
}

TEST_F(Flatten, LevelsPeaksOrValleysAlone) {
  for (const Part part : {both, peaks, valleys}) {
    stroke_.params.set("part", static_cast<float>(part));
    height_ = 0.2f;
    EXPECT_EQ(at(5, 0).z < 0, part != valleys) << part;
    height_ = -0.2f;
    EXPECT_EQ(at(5, 0).z > 0, part != peaks) << part;
  }
}

TEST_F(Flatten, StaysPutWhereTheNormalDoesNotLeadToThePlane) {
  height_ = 0.5f;
  float farthest = 0;
  for (const float lean : {0.0f, 1.0f, 3.0f, 30.0f, 3000.0f}) {
    lean_ = lean;
    farthest = std::max(farthest, std::abs(at(5, 0).z));
  }
  EXPECT_LE(farthest, 1) << "never farther than a radius";
  EXPECT_LT(std::abs(at(5, 0).z), 0.6f);
  height_ = 50;
  lean_ = 0;
  EXPECT_FLOAT_EQ(at(5, 0).z, -1);
}

TEST_F(Flatten, FadesOutAtTheRim) {
  const float full = at(5, 0).z;
  EXPECT_FLOAT_EQ(at(5, 0.8f).z, full / 2);
  EXPECT_EQ(at(5, 1).z, 0);
  EXPECT_EQ(at(-0.8f, 0.6f).z, 0);
}

TEST_F(Flatten, HasNoStep) { expect_no_step(1); }
TEST_F(Flatten, IsFiniteEverywhere) { expect_finite(); }

}  // namespace
}  // namespace burin
