#include "deform/deform_fixtures.h"

#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/deform/evaluate/evaluate.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <map>
#include <mutex>
#include <numeric>
#include <set>
#include <string>
#include <thread>

namespace burin {
namespace {

/// A ridge that looks at everything that could depend on the batch.
burin_status ridge(const burin_stroke_context& context, const burin_batch& batch,
                   const burin_outputs& outputs, burin_text*) {
  for (std::uint32_t i = 0; i < batch.count; ++i) {
    const float t = batch.t.data[i * batch.t.stride], d = batch.d.data[i * batch.d.stride];
    const auto noise = static_cast<float>(batch.node_id.data[i * batch.node_id.stride] % 17);
    outputs.up.data[i * outputs.up.stride] = 0.1f - d * d + 0.001f * noise + static_cast<float>(context.seed);
    outputs.across.data[i * outputs.across.stride] = 0.01f * t;
  }
  return BURIN_OK;
}
constexpr std::uint64_t ridge_inputs = BURIN_INPUT_T | BURIN_INPUT_D | BURIN_INPUT_NODE_ID;

class EvaluateTest : public ::testing::Test {
 protected:
  EvaluateTest() : surface_(test::square(100)), drawn_(surface_, test::straight_chart(surface_, 1, 0.5f)) {
    all_.resize(chart().size());
    std::iota(all_.begin(), all_.end(), 0u);
  }

  std::vector<Vec3f> evaluate(test::TestBrush& brush, std::span<const Index> nodes, float strength = 1) {
    const BrushStroke stroke(brush.brush, brush.descriptor, brush.context, brush.params);
    return evaluator_.evaluate(stroke, brush.context, {surface_, drawn_.nodes, 0.5f}, nodes, strength)
        .displacement;
  }

  const Chart& chart() const { return drawn_.live.nodes(); }

  std::string failure(test::TestBrush& brush) {
    try {
      evaluate(brush, all_);
    } catch (const ContractError& error) {
      return error.what();
    }
    return "none";
  }

  Surface surface_;
  test::DrawnNodes drawn_;
  std::vector<Index> all_;
  Evaluator evaluator_;
};

TEST_F(EvaluateTest, DisplacesByStrength) {
  test::TestBrush brush(ridge_inputs, ridge);
  const std::vector<Vec3f> full = evaluate(brush, all_), half = evaluate(brush, all_, 0.5f);
  ASSERT_EQ(full.size(), 10000u);
  for (const Index node : all_) {
    const Index vertex = chart().vertex[node];
    const Vec3f& base = surface_.positions[vertex];
    const float d = base.y() - 0.5f;
    const float up = 0.1f - d * d + 0.001f * static_cast<float>(surface_.source_vertex[vertex] % 17);
    EXPECT_EQ(full[node].z(), up);
    EXPECT_EQ(full[node].y(), 0.01f * base.x());
    EXPECT_EQ(half[node].z(), 0.5f * up);
  }
}

TEST_F(EvaluateTest, DoesNotDependOnTheSplitIntoBatchesOrThreads) {
  test::TestBrush brush(ridge_inputs, ridge);
  const std::vector<Vec3f> whole = evaluate(brush, all_);
  for (const std::size_t threads : {1u, 2u}) {
    const ThreadLimit limit(threads);
    for (const std::size_t part : {1u, 37u, 1023u, 1024u, 1025u, 4001u}) {
      for (std::size_t begin = 0; begin < all_.size(); begin += part * 3) {
        const auto nodes = std::span(all_).subspan(begin, std::min(part, all_.size() - begin));
        const std::vector<Vec3f> moved = evaluate(brush, nodes);
        for (std::size_t i = 0; i < nodes.size(); ++i) ASSERT_EQ(moved[i], whole[begin + i]) << part;
      }
    }
  }
}

TEST_F(EvaluateTest, EachPassSeesTheOneBeforeAtFullStrength) {
  test::TestBrush brush(BURIN_INPUT_POSITION | BURIN_INPUT_DISPLACEMENT,
                        [](const burin_stroke_context& context, const burin_batch& batch,
                           const burin_outputs& outputs, burin_text*) -> burin_status {
                          for (std::uint32_t i = 0; i < batch.count; ++i) {
                            const float so_far = batch.displacement.z.data[i * batch.displacement.z.stride];
                            if (batch.position.z.data[i * batch.position.z.stride] != so_far)
                              return BURIN_ERROR;
                            outputs.up.data[i] = 2 * so_far + static_cast<float>(context.pass) + 1;
                          }
                          return BURIN_OK;
                        });
  brush.passes = 3;
  // 1, then 2 * 1 + 2, then 2 * 4 + 3.
  for (const Vec3f& moved : evaluate(brush, all_, 0.5f)) EXPECT_EQ(moved.z(), 5.5f);
}

TEST_F(EvaluateTest, NamesTheLowestNodeThatIsNotFinite) {
  const Index lowest = 700;
  const Index lowest_id = surface_.source_vertex[chart().vertex[lowest]];
  // Every batch fails; the lowest node's after those that began earlier, before those that began with it.
  test::TestBrush brush(BURIN_INPUT_NODE_ID,
                        [&](const burin_stroke_context&, const burin_batch& batch,
                            const burin_outputs& outputs, burin_text*) -> burin_status {
                          const std::uint32_t* ids = batch.node_id.data;
                          const std::uint32_t* found = std::find(ids, ids + batch.count, lowest_id);
                          const bool has_lowest = found != ids + batch.count;
                          std::this_thread::sleep_for(std::chrono::milliseconds(has_lowest ? 2 : 4));
                          const std::ptrdiff_t first_bad = has_lowest ? found - ids : 0;
                          for (std::ptrdiff_t i = first_bad; i < batch.count; ++i)
                            outputs.along.data[i] = std::numeric_limits<float>::quiet_NaN();
                          return BURIN_OK;
                        });
  char place[100];
  std::snprintf(place, sizeof(place), "t = %.6g, d = %.6g", chart().t[lowest],
                static_cast<double>(chart().d[lowest]));
  for (const std::size_t threads : {1u, 2u}) {
    const ThreadLimit limit(threads);
    for (int round = 0; round < 5; ++round)
      ASSERT_EQ(failure(brush), "org.burin.test.function: returned a displacement that is not finite at " +
                                    std::string(place));
  }
  EXPECT_EQ(brush.open_strokes, 0);
}

TEST_F(EvaluateTest, PassesOnWhatABrushSaysOfItsFailure) {
  test::TestBrush brush(BURIN_INPUT_D,
                        [](const burin_stroke_context&, const burin_batch&, const burin_outputs&,
                           burin_text* error) -> burin_status {
                          std::snprintf(error->data, error->capacity, "no wood left");
                          return BURIN_ERROR;
                        });
  EXPECT_EQ(failure(brush).find("org.burin.test.function: no wood left at t = "), 0u) << failure(brush);
}

/// Moves everything up by this much.
template <int distance>
burin_status lift(const burin_stroke_context&, const burin_batch& batch, const burin_outputs& outputs,
                  burin_text*) {
  for (std::uint32_t i = 0; i < batch.count; ++i) outputs.up.data[i] = distance;
  return BURIN_OK;
}

TEST_F(EvaluateTest, RefusesToLeaveTheRangeOfFloats) {
  test::TestBrush brush(0, lift<500>);
  EXPECT_EQ(evaluate(brush, all_)[0].z(), 500);
  EXPECT_THROW(evaluate(brush, all_, 1e36F), ContractError);
}

TEST_F(EvaluateTest, RefusesDisplacementsOfMoreThanAThousandRadii) {
  test::TestBrush brush(0, lift<501>);
  EXPECT_EQ(
      failure(brush).find("org.burin.test.function: returned a displacement of 501, more than 1000 radii "
                          "at t = "),
      0u);
}

constexpr float ink[4] = {0.75f, 0.125f, 0.25f, 1};

/// Paints what is black white, without coverage where t is above a half, and takes the mask away.
class TintTest : public EvaluateTest {
 protected:
  TintTest()
      : brush_(BURIN_INPUT_T,
               [](const burin_stroke_context&, const burin_batch& batch, const burin_outputs& outputs,
                  burin_text*) -> burin_status {
                 for (std::uint32_t i = 0; i < batch.count; ++i) {
                   for (int k = 0; k < 3; ++k) outputs.colour[k].data[i] = 1;
                   outputs.colour[3].data[i] = batch.t.data[i] > 0.5f ? 0.0f : 1.0f;
                   outputs.mask.data[i] = 0;
                 }
                 return BURIN_OK;
               }) {
    brush_.descriptor.outputs_written = BURIN_OUTPUT_COLOUR | BURIN_OUTPUT_MASK;
    paint_.colour.assign(surface_.vertex_count(), Vec4f(0, 0, 0, 1));
    for (const Vec3f& place : surface_.positions) paint_.mask.push_back(place.y());
  }

  NodeOutputs tinted(float strength) { return tinted(brush_, strength); }

  NodeOutputs tinted(const test::TestBrush& brush, float strength) {
    const BrushStroke stroke(brush.brush, brush.descriptor, brush.context, brush.params);
    const NodeSource source{.surface = surface_, .nodes = drawn_.nodes, .radius = 0.5f, .paint = &paint_};
    return evaluator_.evaluate(stroke, brush.context, source, all_, strength);
  }

  test::TestBrush brush_;
  Paint paint_;
};

TEST_F(TintTest, GoesByStrengthAndMaskAndTheMaskByStrengthAlone) {
  for (const float strength : {0.0f, 0.25f, 1.0f, 3.0f, -1.0f}) {
    const NodeOutputs outputs = tinted(strength);
    ASSERT_EQ(outputs.tint.size(), all_.size());
    const float share = std::clamp(strength, 0.0f, 1.0f);
    for (const Index node : all_) {
      const Index vertex = chart().vertex[node];
      const float mask = paint_.mask[vertex];
      const bool erased = surface_.positions[vertex].x() > 0.5f;
      ASSERT_NEAR(outputs.tint[node][0], erased ? 0 : share * mask, 1e-6f);
      ASSERT_NEAR(outputs.tint[node][3], erased ? 1 - share * mask : 1, 1e-6f);
      ASSERT_NEAR(outputs.tint[node][4], mask * (1 - share), 1e-6f);
      ASSERT_EQ(outputs.displacement[node], Vec3f(0, 0, 0));
    }
  }
}

// What is not painted is white without coverage, and none of that white is mixed in.
TEST_F(TintTest, OfWhatIsNotPaintedHasTheInksHueAndCoversByStrengthAndMask) {
  test::TestBrush pen(BURIN_INPUT_T,
                      [](const burin_stroke_context&, const burin_batch& batch, const burin_outputs& outputs,
                         burin_text*) -> burin_status {
                        for (std::uint32_t i = 0; i < batch.count; ++i)
                          for (int k = 0; k < 4; ++k) outputs.colour[k].data[i] = ink[k];
                        return BURIN_OK;
                      });
  pen.descriptor.outputs_written = BURIN_OUTPUT_COLOUR;
  paint_.colour.clear();
  const NodeOutputs outputs = tinted(pen, 0.5f);
  std::size_t partial = 0;
  for (const Index node : all_) {
    const Vec4f colour = colour_of(outputs.tint[node]);
    ASSERT_FLOAT_EQ(colour[3], 0.5f * paint_.mask[chart().vertex[node]]);
    if (!(colour[3] > 0)) continue;
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(colour[k], ink[k], 1e-6f);
    ++partial;
  }
  EXPECT_GT(partial, 1000u);
}

TEST_F(EvaluateTest, RefusesColoursAndMasksThatAreNotFinite) {
  for (const bool mask : {false, true}) {
    test::TestBrush brush(BURIN_INPUT_D,
                          [mask](const burin_stroke_context&, const burin_batch&,
                                 const burin_outputs& outputs, burin_text*) -> burin_status {
                            const burin_floats_out& out = mask ? outputs.mask : outputs.colour[1];
                            out.data[0] = std::numeric_limits<float>::infinity();
                            return BURIN_OK;
                          });
    brush.descriptor.outputs_written = mask ? BURIN_OUTPUT_MASK : BURIN_OUTPUT_COLOUR;
    EXPECT_EQ(
        failure(brush).find("org.burin.test.function: returned a colour or mask that is not finite at "), 0u)
        << failure(brush);
  }
}

TEST_F(EvaluateTest, EvaluatesEveryDabWithItsOwnContext) {
  Chart dabs = chart();
  std::vector<float> dab_t;
  for (Index node = 0; node < dabs.size(); ++node) {
    dabs.t[node] = 0.25 * (node % 3);
    dab_t.push_back(0.001f * static_cast<float>(node));
  }
  drawn_.live.assign(dabs);
  std::mutex mutex;
  std::map<double, std::size_t> nodes_of;
  std::set<std::uint64_t> flags;
  test::TestBrush brush(BURIN_INPUT_T | BURIN_INPUT_DISPLACEMENT,
                        [&](const burin_stroke_context& now, const burin_batch& batch,
                            const burin_outputs& outputs, burin_text*) -> burin_status {
                          const std::lock_guard lock(mutex);
                          if (now.pass == 0) nodes_of[now.dab_t] += batch.count;
                          flags.insert(now.flags);
                          if (now.length != 0) return BURIN_ERROR;
                          for (std::uint32_t i = 0; i < batch.count; ++i) {
                            outputs.along.data[i] = batch.t.data[i];
                            outputs.across.data[i] = static_cast<float>(now.dab_t);
                            outputs.up.data[i] = batch.displacement.y.data[i * batch.displacement.y.stride];
                          }
                          return BURIN_OK;
                        });
  brush.passes = 2;
  brush.context.length = 7;
  brush.context.flags = BURIN_STROKE_CLOSED | BURIN_STROKE_MIRRORED;
  const BrushStroke stroke(brush.brush, brush.descriptor, brush.context, brush.params);
  const NodeSource source{.surface = surface_, .nodes = drawn_.nodes, .radius = 0.5f, .dab_t = dab_t};
  const NodeOutputs& outputs = evaluator_.evaluate(stroke, brush.context, source, all_, 1);
  for (const Index node : all_) {
    const auto of = static_cast<float>(dabs.t[node]);
    ASSERT_EQ(outputs.displacement[node], Vec3f(dab_t[node], of, of)) << "the second pass sees the first";
  }
  EXPECT_EQ(nodes_of, (std::map<double, std::size_t>{{0, 3334}, {0.25, 3333}, {0.5, 3333}}));
  EXPECT_EQ(flags, std::set<std::uint64_t>{BURIN_STROKE_DAB | BURIN_STROKE_FINAL | BURIN_STROKE_MIRRORED})
      << "dabs have no ends and do not go around";
}

}  // namespace
}  // namespace burin
