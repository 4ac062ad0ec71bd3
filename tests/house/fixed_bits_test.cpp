// Checks that results are the same bits on every processor: sources call no function of which the C
// library has variants for processors.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "support/shared_data.h"

namespace burin::test {
namespace {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

/// "FILE:LINE" of all uses of such functions below some of a repository's folders. Eigen's turns call them.
Lines uses_of_variants(const fs::path& repository) {
  static const std::regex pattern(
      R"((std::|::|[^:\w.>])(a?sinh?|a?cosh?|a?tanh?|atan2|exp2?|expm1|log2?|log10|log1p|pow|cbrt|hypot|erfc?|[tl]gamma)f?\()"
      R"(|std::(fma|sph_|legendre)|Eigen::(AngleAxis|Rotation2D|Quaternion))");
  static const std::regex fixed(R"(math::\w+\(|^\s*\* .*|//.*$)");
  Lines found;
  for (const char* root : {"sdk/burin", "brushes", "samples"}) {
    if (!fs::exists(repository / root)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(repository / root)) {
      const fs::path file = fs::relative(entry.path(), repository);
      const bool source = file.extension() == ".h" || file.extension() == ".cpp";
      if (!source || file.parent_path() == "sdk/burin/math") continue;
      std::ifstream in(entry.path());
      std::string text;
      for (int line = 1; std::getline(in, text); ++line)
        if (std::regex_search(std::regex_replace(text, fixed, ""), pattern))
          found.push_back(file.generic_string() + ":" + std::to_string(line));
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

TEST(FixedBits, HoldInTheRepository) { EXPECT_EQ(uses_of_variants(BURIN_SOURCE_FOLDER), Lines()); }

TEST(FixedBits, CatchFunctionsOfTheCLibrary) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "brushes");
  std::ofstream(folder.path() / "brushes/a.cpp") << "x = std::sin(y);\n"
                                                    "x = math::sin(y) + std::sqrt(y);  // not std::sin(y)\n"
                                                    "x = math::cos(std::pow(y, 2));\n"
                                                    "x = 2 *expf(y);\n"
                                                    "x = catalog(y) + file.log(y);\n"
                                                    "Eigen::AngleAxisd turn;\n";
  EXPECT_EQ(uses_of_variants(folder.path()),
            Lines({"brushes/a.cpp:1", "brushes/a.cpp:3", "brushes/a.cpp:4", "brushes/a.cpp:6"}));
}

}  // namespace
}  // namespace burin::test
