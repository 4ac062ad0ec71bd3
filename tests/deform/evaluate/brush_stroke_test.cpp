#include "deform/deform_fixtures.h"
#include "support/error_of.h"

#include <burin/deform/evaluate/brush_stroke.h>
#include <gtest/gtest.h>

#include <limits>
#include <optional>

namespace burin {
namespace {

burin_status nothing(const burin_stroke_context&, const burin_batch&, const burin_outputs&, burin_text*) {
  return BURIN_OK;
}

std::string failure(test::TestBrush& brush) {
  return test::error_of([&] { BrushStroke(brush.brush, brush.descriptor, brush.context, brush.params); });
}

TEST(BrushStroke, EndsWhatItBegan) {
  test::TestBrush brush(0, nothing);
  brush.passes = 3;
  brush.end_influence = std::numeric_limits<double>::infinity();
  {
    const BrushStroke stroke(brush.brush, brush.descriptor, brush.context, brush.params);
    EXPECT_EQ(brush.open_strokes, 1);
    EXPECT_EQ(stroke.plan().passes, 3u);
    EXPECT_EQ(stroke.plan().end_influence, std::numeric_limits<double>::infinity());
  }
  EXPECT_EQ(brush.open_strokes, 0);
}

TEST(BrushStroke, NamesTheBrushThatRefusesToBegin) {
  test::TestBrush brush(0, nothing);
  brush.begin_status = BURIN_NOT_FOUND;
  EXPECT_EQ(failure(brush), "org.burin.test.function: not found");
  EXPECT_EQ(brush.open_strokes, 0);
}

TEST(BrushStroke, RefusesAPlanThatIsNone) {
  test::TestBrush no_pass(0, nothing);
  no_pass.passes = 0;
  EXPECT_EQ(failure(no_pass), "org.burin.test.function: asked for 0 passes and an end influence of 0");
  EXPECT_EQ(no_pass.open_strokes, 0);
  for (const double influence : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    test::TestBrush brush(0, nothing);
    brush.end_influence = influence;
    EXPECT_NE(failure(brush), "none") << influence;
    EXPECT_EQ(brush.open_strokes, 0);
  }
}

}  // namespace
}  // namespace burin
