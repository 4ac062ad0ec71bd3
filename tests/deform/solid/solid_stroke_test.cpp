#include <burin/deform/solid/solid_batch.h>
#include <burin/deform/solid/solid_stroke.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "deform/deform_fixtures.h"
#include "support/error_of.h"

namespace burin {
namespace {

constexpr float rod_radius = 0.1F;

/// A brush whose solid is a rod around the stroke.
struct RodBrush : test::TestBrush {
  RodBrush() : TestBrush(BURIN_INPUT_D, nullptr) {
    brush.get_extension = [](const burin_brush* self, const char* id) -> const void* {
      return std::string(id) == BURIN_EXT_VOLUME ? &of(self).volume : nullptr;
    };
    volume.struct_size = sizeof(volume);
    volume.plan = [](const burin_brush* self, void*, const burin_stroke_context*, const burin_params*,
                     burin_solid_plan* made, burin_text*) {
      *made = of(self).plan;
      return of(self).plan_status;
    };
    volume.distance = [](const burin_brush* self, void*, const burin_stroke_context*,
                         const burin_batch* batch, burin_floats h, burin_floats_out distance, burin_text*) {
      for (std::size_t i = 0; i < batch->count; ++i)
        distance.data[i * distance.stride] =
            std::hypot(batch->d.data[i * batch->d.stride], h.data[i * h.stride]) - rod_radius;
      return of(self).distance_status;
    };
  }

  burin_volume volume{};
  burin_solid_plan plan{sizeof(burin_solid_plan), BURIN_SOLID_UNION, -0.3, 0.3, 0.2};
  burin_status plan_status = BURIN_OK, distance_status = BURIN_OK;

 private:
  static RodBrush& of(const burin_brush* brush) {
    return static_cast<RodBrush&>(*static_cast<TestBrush*>(brush->self));
  }
};

StrokeSolid solid_of(RodBrush& brush, double voxel) {
  const Surface surface = test::square(24);
  Chart chart = test::straight_chart(surface, 1, 0.3F);
  chart.length = 1;
  const test::DrawnNodes drawn(surface, chart);
  const BrushStroke stroke(brush.brush, brush.descriptor, brush.context, brush.params);
  return SolidStroke(stroke).make({surface, drawn.nodes, 0.3F}, brush.context, voxel, false);
}

/// What becomes of the solid of this brush.
SolidOperation operation_of(RodBrush& brush) {
  const BrushStroke stroke(brush.brush, brush.descriptor, brush.context, brush.params);
  return SolidStroke(stroke).operation(brush.context);
}

TEST(SolidStroke, HasTheDistancesOfTheBrush) {
  RodBrush brush;
  const StrokeSolid solid = solid_of(brush, 0);
  EXPECT_DOUBLE_EQ(solid.voxel(), brush.plan.detail / 6);
  int compared = 0;
  for (const VoxelBlock& block : solid.blocks())
    for (int i = 0; i < VoxelBlock::voxels; ++i) {
      const Eigen::Vector3i voxel = block.origin + Eigen::Vector3i(i / 64, i / 8 % 8, i % 8);
      const Vec3d at = voxel.cast<double>() * solid.voxel();
      const double expected = std::hypot(at.y() - 0.5, at.z()) - static_cast<double>(rod_radius);
      if (at.x() < 0.2 || at.x() > 0.8 || std::abs(expected) > 2 * solid.voxel()) continue;
      ASSERT_NEAR(block.values[static_cast<std::size_t>(i)], expected, 1e-5) << at.transpose();
      ++compared;
    }
  EXPECT_GT(compared, 500);
}

TEST(SolidStroke, NamesTheBrushThatFails) {
  RodBrush no_distance;
  no_distance.distance_status = BURIN_NOT_FOUND;
  EXPECT_EQ(test::error_of([&] { solid_of(no_distance, 0); }), "org.burin.test.function: not found");
  RodBrush no_plan;
  no_plan.plan_status = BURIN_NOT_FOUND;
  EXPECT_EQ(test::error_of([&] { solid_of(no_plan, 0); }), "org.burin.test.function: not found");
}

TEST(SolidStroke, NamesTheBrushWhoseSolidNeedsTooMuchMemory) {
  RodBrush brush;
  const std::string error = test::error_of([&] { solid_of(brush, 1e-7); });
  EXPECT_TRUE(error.starts_with("org.burin.test.function: ")) << error;
}

TEST(SolidStroke, RefusesBrushesWithoutSolids) {
  RodBrush none;
  none.brush.get_extension = [](const burin_brush*, const char*) -> const void* { return nullptr; };
  EXPECT_EQ(test::error_of([&] { operation_of(none); }), "org.burin.test.function: makes no solids");
  RodBrush reading;
  reading.descriptor.inputs_read |= ~SolidBatch::inputs_offered;
  EXPECT_EQ(test::error_of([&] { operation_of(reading); }),
            "org.burin.test.function: reads inputs that solids do not have");
}

TEST(SolidStroke, RefusesAPlanThatIsNone) {
  const auto refused = [](const burin_solid_plan& plan) {
    RodBrush brush;
    brush.plan = plan;
    return test::error_of([&] { operation_of(brush); }) != "none";
  };
  const double none = std::numeric_limits<double>::quiet_NaN();
  const burin_solid_plan good = RodBrush().plan;
  EXPECT_FALSE(refused(good));
  for (const double h_max : {good.h_min, none}) {
    burin_solid_plan plan = good;
    plan.h_max = h_max;
    EXPECT_TRUE(refused(plan)) << h_max;
  }
  for (const double detail : {0.0, none}) {
    burin_solid_plan plan = good;
    plan.detail = detail;
    EXPECT_TRUE(refused(plan)) << detail;
  }
  burin_solid_plan plan = good;
  plan.operation = BURIN_SOLID_INTERSECTION + 1;
  EXPECT_TRUE(refused(plan));
}

TEST(SolidStroke, HasTheOperationOfTheBrush) {
  RodBrush brush;
  EXPECT_EQ(operation_of(brush), SolidOperation::unite);
  brush.plan.operation = BURIN_SOLID_SEPARATE;
  EXPECT_EQ(operation_of(brush), SolidOperation::separate);
  brush.plan.operation = BURIN_SOLID_DIFFERENCE;
  EXPECT_EQ(operation_of(brush), SolidOperation::difference);
  brush.plan.operation = BURIN_SOLID_INTERSECTION;
  EXPECT_EQ(operation_of(brush), SolidOperation::intersection);
}

}  // namespace
}  // namespace burin
