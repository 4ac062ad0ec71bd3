#include <burin/base/program_file.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

TEST(ProgramFile, IsThatOfTheTests) { EXPECT_EQ(program_file().filename(), "base_test"); }

TEST(ProgramFile, HasBesideItWhatIsThereAndElseWhatIsInstalled) {
  const std::filesystem::path folder = program_file().parent_path();
  EXPECT_EQ(beside_own_file("base_test"), folder / "base_test");
  EXPECT_EQ(beside_own_file("no such file"), folder.parent_path() / "lib/burin/no such file");
}

}  // namespace
}  // namespace burin
