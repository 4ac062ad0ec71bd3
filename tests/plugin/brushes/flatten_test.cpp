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

  /// Places `height_` over a plane that leans, with normals that are not the plane's.
  void add_inputs(Nodes& nodes) override {
    const float r = nodes.radius;
    for (std::size_t i = 0; i < nodes.t.size(); ++i) {
      nodes.foot.push_back({3 * r, 2 * r, r});
      nodes.foot_normal.push_back(plane_);
      nodes.normal.push_back(normal());
      nodes.e1.push_back(e1());
      const Vector on_plane{plane_.y, -plane_.x, 0};
      nodes.fine_position.push_back({3 * r + r * (on_plane.x + height_ * plane_.x),
                                     2 * r + r * (on_plane.y + height_ * plane_.y),
                                     r + r * height_ * plane_.z});
    }
  }

  Vector normal() const { return unit({plane_.x + lean_, plane_.y - lean_, plane_.z}); }
  Vector e1() const { return unit({normal().z, 0, -normal().x}); }

  /// The position of the first node after its displacement.
  Vector place_after(const Nodes& nodes, const Vector& moved) const {
    const Vector &p = nodes.fine_position[0], n = normal(), x = e1();
    const Vector y{n.y * x.z - n.z * x.y, n.z * x.x - n.x * x.z, n.x * x.y - n.y * x.x};
    return {p.x + moved.x * x.x + moved.y * y.x + moved.z * n.x,
            p.y + moved.x * x.y + moved.y * y.y + moved.z * n.y,
            p.z + moved.x * x.z + moved.y * y.z + moved.z * n.z};
  }
  float height_of(const Vector& place, const Nodes& nodes) const {
    const Vector& foot = nodes.foot[0];
    return (place.x - foot.x) * plane_.x + (place.y - foot.y) * plane_.y + (place.z - foot.z) * plane_.z;
  }

  const Vector plane_ = unit({1, 2, 3});
  float lean_ = 0.1f, height_ = 0.2f;
};

TEST_F(Flatten, ReachesThePlaneOnTheShortestWay) {
  for (const float lean : {0.0f, 0.1f, 1.0f, -30.0f}) {
    for (const float height : {0.3f, -0.3f, 0.01f}) {
      lean_ = lean;
      height_ = height;
      Nodes nodes{{5}, {0.1f}};
      add_inputs(nodes);
      const Vector &before = nodes.fine_position[0], after = place_after(nodes, at(5, 0.1f));
      EXPECT_NEAR(height_of(before, nodes), height, 1e-6f);
      EXPECT_NEAR(height_of(after, nodes), 0, 1e-6f);
      EXPECT_NEAR(std::hypot(after.x - before.x, after.y - before.y, after.z - before.z), std::abs(height),
                  1e-6f);
    }
  }
  stroke_.params.set("amount", 0.25f);
  Nodes nodes{{5}, {0}};
  add_inputs(nodes);
  EXPECT_NEAR(height_of(place_after(nodes, at(5, 0)), nodes), 0.75f * height_, 1e-6f);
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

TEST_F(Flatten, GoesNoFartherThanARadius) {
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
