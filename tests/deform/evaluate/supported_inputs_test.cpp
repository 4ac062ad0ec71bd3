#include <burin/deform/evaluate/supported_inputs.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

TEST(Offered, NamesInputsByTheirBits) {
  EXPECT_EQ(input_names(BURIN_INPUT_T), "t");
  EXPECT_EQ(input_names(BURIN_INPUT_LAPLACIAN | BURIN_INPUT_MASK), "laplacian, mask");
  EXPECT_EQ(input_names(BURIN_INPUT_SYMMETRY), "symmetry");
  EXPECT_EQ(input_names(BURIN_INPUT_TIME), "time");
  EXPECT_EQ(
      input_names(BURIN_INPUT_FINE_POSITION | BURIN_INPUT_FINE_NORMAL | BURIN_INPUT_FINE_MEAN_CURVATURE),
      "fine position, fine normal, fine mean curvature");
  EXPECT_EQ(input_names(UINT64_C(1) << 40), "number 40");
}

TEST(Offered, NamesOutputsByTheirBits) {
  EXPECT_EQ(output_names(BURIN_OUTPUT_COLOUR), "colour");
  EXPECT_EQ(output_names(BURIN_OUTPUT_MASK), "mask");
}

}  // namespace
}  // namespace burin
