// Checks what a ray tells of boxes against doubles: never too far, and never a miss where it meets the box.
#include <burin/surface/picking/box_ray.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace burin {
namespace {

using Box = Eigen::AlignedBox3f;

constexpr double none = std::numeric_limits<double>::infinity();

/// The distance at which a ray enters a box, in lengths of its direction, in doubles.
double entered(const Box& box, const Ray& ray) {
  double enter = 0, leave = none;
  for (int axis = 0; axis < 3; ++axis) {
    const double origin = ray.origin[axis], along = ray.direction[axis];
    if (along == 0) {
      if (origin < box.min()[axis] || origin > box.max()[axis]) return none;
      continue;
    }
    const double low = (box.min()[axis] - origin) / along, high = (box.max()[axis] - origin) / along;
    enter = std::max(enter, std::min(low, high));
    leave = std::min(leave, std::max(low, high));
  }
  return enter <= leave ? enter : none;
}

/// Numbers that are often 0, or the same as others.
class Numbers {
 public:
  explicit Numbers(unsigned seed) : generator_(seed) {}

  float next() {
    const int kind = kind_(generator_);
    return kind == 0 ? 0 : kind == 1 ? 0.5F : even_(generator_);
  }
  Vec3f point() {
    const float x = next(), y = next(), z = next();
    return {x, y, z};
  }

 private:
  std::mt19937 generator_;
  std::uniform_int_distribution<int> kind_{0, 4};
  std::uniform_real_distribution<float> even_{-1, 1};
};

/// Of many rays and boxes of this size; directions are `length` times as long. Some boxes have no thickness.
void expect_bounds(float size, float length) {
  constexpr unsigned seed = 20261201;
  Numbers numbers(seed);
  const Box whole(size * Vec3f::Constant(-1), size * Vec3f::Constant(1));
  int met = 0, missed = 0, told = 0;
  for (int i = 0; i < 20000; ++i) {
    const Ray ray{size * numbers.point(), length * numbers.point()};
    if (ray.direction.isZero(0)) continue;
    BoxLanes boxes;
    Box box[BoxLanes::count];
    for (std::size_t lane = 0; lane < BoxLanes::count; ++lane) {
      box[lane].extend(size * numbers.point()).extend(size * numbers.point());
      boxes.set(lane, box[lane]);
    }
    const BoxLanes::Lane nearest = BoxRay(whole, ray).nearest(boxes);
    for (std::size_t lane = 0; lane < BoxLanes::count; ++lane) {
      const double exact = entered(box[lane], ray), bound = nearest[static_cast<Eigen::Index>(lane)];
      (exact < none ? met : missed) += 1;
      if (!(exact < none)) continue;
      ASSERT_LE(bound, exact) << "seed " << seed << ", ray " << i << ", size " << size << ", length "
                              << length;
      if (bound >= exact * (1 - 1e-6)) ++told;
    }
  }
  EXPECT_GT(met, 10000);
  EXPECT_GT(missed, 10000);
  EXPECT_EQ(told, met);
}

TEST(BoxRay, IsNeverTooFarNorMisses) {
  for (const float size : {1e-12F, 1.F, 1e12F})
    for (const float length : {1e-9F, 1.F, 1e9F}) expect_bounds(size, length);
}

TEST(BoxRay, MissesBoxesThatAreEmpty) {
  const Box whole(Vec3f::Constant(-1), Vec3f::Constant(1));
  for (const float x : {-1.F, 0.F, 1.F})
    EXPECT_TRUE((BoxRay(whole, {Vec3f::Zero(), {x, 1, -1}}).nearest(BoxLanes()) == BoxRay::infinity).all());
}

}  // namespace
}  // namespace burin
