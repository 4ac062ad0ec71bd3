// Sources of a room are compiled together, so what they keep to themselves has different names.
#include "name_rules.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "plant.h"
#include "support/shared_data.h"

namespace burin::test {
namespace {

using Told = std::vector<std::string>;

TEST(NameRules, HoldInTheRepository) { EXPECT_EQ(repeated_names(BURIN_SOURCE_FOLDER), Told()); }

TEST(NameRules, CatchWhatTwoSourcesOfARoomDefine) {
  const TemporaryFolder folder;
  const auto source = [](const std::string& hidden) {
    return "namespace burin {\nnamespace {\n\n" + hidden +
           "\n}  // namespace\n\nint seen() { return 1; }\n}\n";
  };
  plant(
      folder.path() / "sdk/burin/chart/a.cpp",
      source(
          "constexpr double radius = 1;\nstruct Part {\n};\nusing Json = int;\nusing Same = int;\n"
          "int count(const Part& part, int of) {\n  const double depth = 1;\n}\ndouble size(int of) {\n}\n"));
  plant(folder.path() / "sdk/burin/chart/b.cpp",
        source("const int radius = 2;\nclass Part final {\n};\nusing Json = long;\nusing Same = int;\n"
               "int count(const Part& other, int one) {\n  const double depth = 1;\n}\ndouble size(double "
               "of) {\n}\n"));
  plant(folder.path() / "sdk/burin/chart/front/c.cpp", source("constexpr double radius = 1;\n"));
  EXPECT_EQ(repeated_names(folder.path()),
            (Told{"sdk/burin/chart: Json: a.cpp b.cpp", "sdk/burin/chart: Part: a.cpp b.cpp",
                  "sdk/burin/chart: count(const Part&, int): a.cpp b.cpp",
                  "sdk/burin/chart: radius: a.cpp b.cpp"}));
}

}  // namespace
}  // namespace burin::test
