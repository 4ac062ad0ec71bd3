#include <burin/deform/evaluate/supported_inputs.h>
#include <gtest/gtest.h>

#include <bit>

namespace burin {
namespace {

TEST(SupportedInputs, NamesInputsByTheirBits) {
  EXPECT_EQ(input_names(BURIN_INPUT_T), "t");
  EXPECT_EQ(input_names(BURIN_INPUT_LAPLACIAN | BURIN_INPUT_MASK), "laplacian, mask");
  EXPECT_EQ(input_names(BURIN_INPUT_SYMMETRY), "symmetry");
  EXPECT_EQ(input_names(BURIN_INPUT_TIME), "time");
  EXPECT_EQ(
      input_names(BURIN_INPUT_FINE_POSITION | BURIN_INPUT_FINE_NORMAL | BURIN_INPUT_FINE_MEAN_CURVATURE),
      "fine position, fine normal, fine mean curvature");
  EXPECT_EQ(input_names(BURIN_INPUT_END_DISTANCE), "end distance");
  EXPECT_EQ(input_names(UINT64_C(1) << 40), "number 40");
}

TEST(SupportedInputs, NamesOutputsByTheirBits) {
  EXPECT_EQ(output_names(BURIN_OUTPUT_COLOUR), "colour");
  EXPECT_EQ(output_names(BURIN_OUTPUT_MASK), "mask");
}

TEST(SupportedInputs, TakeTheColumnsThatTheirMembersLookInto) {
  const auto columns = [](std::uint64_t bit) { return all_inputs[std::countr_zero(bit)].columns; };
  EXPECT_EQ(columns(BURIN_INPUT_T), 1u);
  EXPECT_EQ(columns(BURIN_INPUT_FOOTPRINT), 2u);
  EXPECT_EQ(columns(BURIN_INPUT_NORMAL), 3u);
  EXPECT_EQ(columns(BURIN_INPUT_COLOUR), 4u);
  EXPECT_EQ(columns(BURIN_INPUT_FOOT), 6u);
  EXPECT_EQ(columns(BURIN_INPUT_SHEET), 0u) << "whole numbers";
  EXPECT_EQ(sum(all_inputs).columns, 47u);
  EXPECT_EQ(sum(all_outputs).columns, 8u);
}

}  // namespace
}  // namespace burin
