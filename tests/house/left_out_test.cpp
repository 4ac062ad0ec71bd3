// Checks that what tests with sanitizers leave out, by tests/sanitizers/*.txt, are tests that there are.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "all_matches.h"
#include "plant.h"
#include "support/shared_data.h"

namespace burin::test {
namespace {

namespace fs = std::filesystem;
using TestNames = std::vector<std::string>;

std::string text_of(const fs::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// "SUITE.TEST" of all tests, "PREFIX/SUITE." of those with parameters, and the beginnings of names that
/// CMake gives.
TestNames tests_of(const fs::path& repository) {
  static const std::regex test(R"(\bTEST(?:_F|_P|)\(\s*(\w+,\s*\w+)\))");
  static const std::regex prefix(R"(\bINSTANTIATE_TEST_SUITE_P\(\s*(\w+,\s*\w+))");
  static const std::regex of_cmake(R"(add_test\(NAME (\w+\.))");
  static const std::regex comma(",\\s*");
  TestNames tests;
  for (const auto& entry : fs::recursive_directory_iterator(repository / "tests")) {
    if (!entry.is_regular_file()) continue;
    const std::string text = text_of(entry.path());
    for (const std::string& name : all_matches<TestNames>(text, test))
      tests.push_back(std::regex_replace(name, comma, "."));
    for (const std::string& name : all_matches<TestNames>(text, prefix))
      tests.push_back(std::regex_replace(name, comma, "/") + ".");
    for (const std::string& name : all_matches<TestNames>(text, of_cmake)) tests.push_back(name);
  }
  return tests;
}

/// The regular expressions that match no test.
TestNames vain_expressions(const fs::path& repository) {
  const TestNames tests = tests_of(repository);
  TestNames vain;
  for (const char* file : {"long.txt", "thread.txt"}) {
    std::ifstream lines(repository / "tests/sanitizers" / file);
    for (std::string line; std::getline(lines, line);) {
      if (line.empty() || line.front() == '#') continue;
      const std::regex expression(line);
      if (std::ranges::none_of(tests, [&](const std::string& t) { return std::regex_search(t, expression); }))
        vain.push_back(line);
    }
  }
  return vain;
}

TEST(LeftOut, HoldInTheRepository) { EXPECT_EQ(vain_expressions(BURIN_SOURCE_FOLDER), TestNames()); }

TEST(LeftOut, CatchExpressionsThatMatchNoTest) {
  const TemporaryFolder folder;
  plant(folder.path() / "tests/a_test.cpp",
        "TEST(Groove, IsDeep) {}\nTEST_P(Bead,\n       IsHigh) {}\n"
        "INSTANTIATE_TEST_SUITE_P(Odd, Bead,\n  Values(1));\n");
  plant(folder.path() / "tests/sanitizers/long.txt",
        "# all\n\n^Groove\\.\n^Groove\\.IsHigh$\n^Odd/\n^Even/\n/Bead\\.\n");
  plant(folder.path() / "tests/sanitizers/thread.txt", "^Bead\\.Is(Low|High)\n^IsDeep\n");
  EXPECT_EQ(vain_expressions(folder.path()), TestNames({"^Groove\\.IsHigh$", "^Even/", "^IsDeep"}));
}

}  // namespace
}  // namespace burin::test
