#include <burin/deform/evaluate/batch_params.h>
#include <gtest/gtest.h>

#include "deform/varying_brush.h"

namespace burin {
namespace {

PenAt at(double t) {
  PenAt at;
  at.t = t;
  return at;
}

TEST(BatchParams, HandOnConstantParametersAsTheyAre) {
  const test::VaryingBrush brush;
  BatchParams params;
  EXPECT_EQ(&params.fill(brush.params, NodeDynamics(nullptr), std::vector<Index>{0, 1}), &brush.params);
}

TEST(BatchParams, HoldANumberForEachElementWhereTheyVary) {
  const test::VaryingBrush brush;
  const std::vector<Dynamic> of_all{{"turn", PenSource::t, {0, 0, 1, 1}},
                                    {"count", PenSource::t, {0, 0, 1, 1}}};
  const ParamDynamics dynamics(brush.descriptor, brush.params, of_all, {});
  NodeDynamics nodes(&dynamics);
  nodes.resize(10);
  for (Index slot = 0; slot < 10; ++slot) nodes.update(slot, at(slot / 10.), 0);

  BatchParams batch;
  for (const std::vector<Index>& split : {std::vector<Index>{7, 2, 9}, std::vector<Index>{4}}) {
    const burin_params& params = batch.fill(brush.params, nodes, split);
    ASSERT_EQ(params.count, brush.params.count);
    EXPECT_EQ(params.values[0].number.stride, 0) << "does not vary";
    EXPECT_EQ(params.values[0].number.data[0], 2);
    const burin_floats turn = params.values[1].number, count = params.values[2].number;
    EXPECT_EQ(turn.stride, 1);
    EXPECT_EQ(count.stride, 1);
    for (std::size_t i = 0; i < split.size(); ++i) {
      EXPECT_FLOAT_EQ(turn.data[i], 0.5F + static_cast<float>(split[i]) / 10);
      EXPECT_EQ(count.data[i], std::max(1.F, std::round(0.7F * static_cast<float>(split[i]))));
    }
  }
}

}  // namespace
}  // namespace burin
