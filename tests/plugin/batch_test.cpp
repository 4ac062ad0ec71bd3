#include <burin/plugin/batch.h>
#include <burin/plugin/outputs.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace burin {
namespace {

using plugin::Batch;

constexpr std::uint64_t every_input = (BURIN_INPUT_TIME << 1) - 1;

/// Inputs whose only values are the bit numbers of their declarations.
class Inputs : public testing::Test {
 protected:
  float values_[32];
  std::uint32_t indices_[32];
  burin_brush_descriptor brush_{};
  burin_stroke_context context_{};
  burin_batch batch_{};

  burin_floats at(int bit) { return {&values_[bit], 0, 0}; }

  void SetUp() override {
    for (int i = 0; i < 32; ++i) values_[i] = static_cast<float>(indices_[i] = static_cast<std::uint32_t>(i));
    brush_.inputs_read = every_input;
    context_.struct_size = sizeof context_;
    batch_.struct_size = sizeof batch_;
    batch_.count = 5;
    burin_floats* const floats[] = {&batch_.t, &batch_.d, &batch_.radius, &batch_.stretch,
                                    &batch_.footprint_t};
    for (int i = 0; i < 5; ++i) *floats[i] = at(i);
    batch_.footprint_d = at(4);
    batch_.position = {at(5), at(5), at(5)};
    batch_.normal = {at(6), at(6), at(6)};
    batch_.e1 = {at(7), at(7), at(7)};
    batch_.mean_curvature = at(8);
    batch_.laplacian = {at(9), at(9), at(9)};
    batch_.displacement = {at(10), at(10), at(10)};
    batch_.mask = at(11);
    batch_.colour = {at(12), at(12), at(12), at(12)};
    batch_.sheet = {&indices_[13], 0, 0};
    batch_.visit_count = {&indices_[14], 0, 0};
    batch_.node_id = {&indices_[15], 0, 0};
    batch_.symmetry = {&indices_[16], 0, 0};
    batch_.pressure = at(17);
    batch_.tilt_x = batch_.tilt_y = at(18);
    batch_.twist = at(19);
    batch_.speed = at(20);
    batch_.time = at(21);
  }

  Batch batch() const { return {brush_, context_, batch_}; }

  std::string refusal(const plugin::Floats (*read)(const Batch&)) const {
    try {
      read(batch());
    } catch (const plugin::Error& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(Inputs, ArriveUnderTheirNames) {
  const Batch in = batch();
  EXPECT_EQ(in.size(), 5u);
  const plugin::Floats floats[] = {in.t(), in.d(), in.radius(), in.stretch(), in.footprint_t()};
  for (int i = 0; i < 5; ++i) EXPECT_EQ(floats[i][4], static_cast<float>(i));
  EXPECT_EQ(in.footprint_d()[0], 4);
  EXPECT_EQ(in.position().y[0], 5);
  EXPECT_EQ(in.normal().z[0], 6);
  EXPECT_EQ(in.e1().x[0], 7);
  EXPECT_EQ(in.mean_curvature()[0], 8);
  EXPECT_EQ(in.laplacian().x[0], 9);
  EXPECT_EQ(in.displacement().z[0], 10);
  EXPECT_EQ(in.mask()[0], 11);
  EXPECT_EQ(in.colour().a[0], 12);
  EXPECT_EQ(in.sheet()[0], 13u);
  EXPECT_EQ(in.visit_count()[0], 14u);
  EXPECT_EQ(in.node_id()[0], 15u);
  EXPECT_EQ(in.symmetry()[0], 16u);
  EXPECT_EQ(in.pressure()[0], 17);
  EXPECT_EQ(in.tilt_x()[0], 18);
  EXPECT_EQ(in.tilt_y()[0], 18);
  EXPECT_EQ(in.twist()[0], 19);
  EXPECT_EQ(in.speed()[0], 20);
  EXPECT_EQ(in.time()[0], 21);
}

TEST_F(Inputs, AreRefusedWhenNotDeclared) {
  brush_.inputs_read = every_input & ~BURIN_INPUT_D & ~BURIN_INPUT_PRESSURE;
  EXPECT_EQ(refusal([](const Batch& in) -> const plugin::Floats { return in.d(); }),
            "the brush reads input 'd' without declaring it");
  EXPECT_EQ(refusal([](const Batch& in) -> const plugin::Floats { return in.pressure(); }),
            "the brush reads input 'pressure' without declaring it");
  EXPECT_EQ(refusal([](const Batch& in) -> const plugin::Floats { return in.t(); }), "");
}

TEST_F(Inputs, OfThePenAreNeutralBeyondAnOlderHostsBatch) {
  batch_.struct_size = offsetof(burin_batch, pressure);
  const Batch in = batch();
  EXPECT_EQ(in.symmetry()[0], 16u);
  EXPECT_EQ(in.pressure()[4], 1);
  EXPECT_EQ(in.tilt_x()[4], 0);
  EXPECT_EQ(in.tilt_y()[4], 0);
  EXPECT_EQ(in.twist()[4], 0);
  EXPECT_EQ(in.speed()[4], 0);
  EXPECT_EQ(in.time()[4], 0);
}

TEST_F(Inputs, WithoutANeutralValueAreRefusedBeyondAnOlderHostsBatch) {
  batch_.struct_size = offsetof(burin_batch, mask);
  EXPECT_EQ(refusal([](const Batch& in) -> const plugin::Floats { return in.mask(); }),
            "this host does not offer input 'mask'");
  EXPECT_EQ(batch().displacement().x[0], 10);
}

TEST_F(Inputs, OfTheContextAreZeroBeyondAnOlderHostsContext) {
  context_.length = 3;
  context_.radius_max = 2;
  context_.flags = BURIN_STROKE_CLOSED;
  context_.pen_present = BURIN_INPUT_TILT;
  context_.struct_size = offsetof(burin_stroke_context, radius_max);
  const Batch in = batch();
  EXPECT_EQ(in.stroke.length(), 3);
  EXPECT_EQ(in.stroke.radius_max(), 0);
  EXPECT_TRUE(in.stroke.closed());
  EXPECT_FALSE(in.stroke.finished());
  EXPECT_TRUE(in.stroke.has_pen(BURIN_INPUT_TILT));
  EXPECT_FALSE(in.stroke.has_pen(BURIN_INPUT_PRESSURE));
}

TEST_F(Inputs, GiveTheDistanceBesideTheStrokeAndRoundItsEnds) {
  context_.length = 10;
  const Batch open = batch();
  EXPECT_EQ(open.stroke.distance(0, -2), 2);
  EXPECT_EQ(open.stroke.distance(10, 2), 2);
  EXPECT_EQ(open.stroke.distance(-3, 4), 5);
  EXPECT_EQ(open.stroke.distance(13, -4), 5);
  context_.flags = BURIN_STROKE_CLOSED;
  EXPECT_EQ(batch().stroke.distance(13, -4), 4);
}

TEST(Outputs, GoWhereTheHostSays) {
  float values[8][6] = {};
  burin_outputs raw{sizeof raw,        2, {values[0], 3, 0}, {values[1], 3, 0}, {values[2], 3, 0},
                    {values[3], 3, 0}, {}};
  for (int i = 0; i < 4; ++i) raw.colour[i] = {values[4 + i], 3, 0};
  const plugin::Outputs out(raw);
  out.along()[1] = 1;
  out.across()[1] = 2;
  out.up()[1] = 3;
  out.mask()[1] = 4;
  out.colour().r[1] = 5;
  out.colour().g[1] = 6;
  out.colour().b[1] = 7;
  out.colour().a.from(1)[0] = 8;
  for (int i = 0; i < 8; ++i) EXPECT_EQ(values[i][3], static_cast<float>(i + 1));
}

TEST(Outputs, AreRefusedWhenNotDeclaredOrNotKnownToTheHost) {
  float value = 0;
  burin_outputs raw{};
  raw.struct_size = offsetof(burin_outputs, mask);
  raw.up = raw.mask = {&value, 1, 0};
  const plugin::Outputs out(raw);
  out.up()[0] = 1;
  EXPECT_EQ(value, 1);
  EXPECT_THROW(out.along(), plugin::Error);
  EXPECT_THROW(out.mask(), plugin::Error);
}

}  // namespace
}  // namespace burin
