#include <burin/deform/evaluate/error_text.h>
#include <gtest/gtest.h>

#include <cstring>

namespace burin {
namespace {

TEST(ErrorText, IsOneLineWhateverThePluginWrote) {
  ErrorText error;
  std::strcpy(error.abi()->data, "two\nlines\tand\x7f");
  EXPECT_EQ(error.line(BURIN_ERROR), "two lines and ");
}

TEST(ErrorText, EndsAtTheBufferWhenTheZeroIsMissing) {
  ErrorText error;
  std::memset(error.abi()->data, 'x', error.abi()->capacity);
  EXPECT_EQ(error.line(BURIN_ERROR), std::string(error.abi()->capacity, 'x'));
}

TEST(ErrorText, SpeaksForAPluginThatIsSilent) {
  EXPECT_EQ(ErrorText().line(BURIN_NOT_FOUND), "not found");
  EXPECT_EQ(ErrorText().line(77), "failed with the unknown status 77");
}

}  // namespace
}  // namespace burin
