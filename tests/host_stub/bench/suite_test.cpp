#include "bench_suite.h"

#include <gtest/gtest.h>

namespace burin::test {
namespace {

using nlohmann::json;

struct BadSuite {
  const char* name;
  json members;  // of the suite's second case, besides or instead of those of a good one; null: taken out
  std::string what;
};

void PrintTo(const BadSuite& bad, std::ostream* out) { *out << bad.name; }

class BenchSuiteErrors : public testing::TestWithParam<BadSuite> {};

TEST_P(BenchSuiteErrors, NameFileAndPlaceInOneLine) {
  const BenchFolder folder;
  json bad = BenchFolder::bench_case("b");
  bad.merge_patch(GetParam().members);
  const std::string suite = folder.write_suite({BenchFolder::bench_case("a"), bad});
  const auto before = folder.content();
  const ProcessResult result = burin({"bench", suite, "--json", "--report", folder.path("report")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err.rfind("burin: " + suite + ": cases[1]" + GetParam().what, 0), 0u) << result.err;
  EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
  EXPECT_EQ(folder.content(), before);
}

const json made_stroke = {{"samples", 20}, {"from", {0, 0, 1}}, {"towards", {1, 0, 1}}, {"length_radii", 4}};

json made_with(const json& members) {
  json stroke = made_stroke;
  stroke.merge_patch(members);
  return {{"strokes", nullptr}, {"brush", "org.burin.groove"}, {"radius", 0.2}, {"stroke", stroke}};
}

INSTANTIATE_TEST_SUITE_P(
    All, BenchSuiteErrors,
    testing::Values(
        BadSuite{"UnknownKey", {{"raduis", 1}}, ".raduis: is not known"},
        BadSuite{"NoName", {{"name", nullptr}}, ": lacks 'name'"},
        BadSuite{"SameName", {{"name", "a"}}, ".name: is the name of an earlier case"},
        BadSuite{"NumberForText", {{"mesh", 3}}, ".mesh: must be a text"},
        BadSuite{"NoMesh", {{"mesh", "none.obj"}}, ".mesh: there is no file "},
        BadSuite{"NoStroke", {{"strokes", {"a.stroke", "b.stroke"}}}, ".strokes[1]: there is no file "},
        BadSuite{"EmptyStrokes", {{"strokes", json::array()}}, ".strokes: names no file"},
        BadSuite{"NeitherStroke", {{"strokes", nullptr}}, ": takes either 'strokes' or 'stroke'"},
        BadSuite{"BothStrokes", {{"stroke", made_stroke}}, ": takes either 'strokes' or 'stroke'"},
        BadSuite{"TextForNumber", {{"radius", "wide"}}, ".radius: must be a number above 0"},
        BadSuite{"NegativeRadius", {{"radius", -1}}, ".radius: must be a number above 0"},
        BadSuite{"TwoRadii", {{"radius", 1}, {"radius_edges", 5}}, ": takes either 'radius' or"},
        BadSuite{"Fraction", {{"repeat", 1.5}}, ".repeat: must be a whole number from 1 to 1000"},
        BadSuite{"NoRepeat", {{"repeat", 0}}, ".repeat: must be a whole number from 1 to 1000"},
        BadSuite{"TwoSizes", {{"subdivide", 1}, {"target_triangles", 9}}, ": takes either 'subdivide' or"},
        BadSuite{"UnknownOverlap", {{"overlap", "sum"}}, ".overlap: must be one of add, average, latest"},
        BadSuite{"UnknownAxis", {{"axis", "size"}}, ".axis: must be one of mesh, none, region"},
        BadSuite{"WidthShare", {{"pressure_width", 2}}, ".pressure_width: must be a number from 0 to 1"},
        BadSuite{"Params", {{"params", {{"depth", {{"a", 1}}}}}}, ".params.depth: must be a number"},
        BadSuite{"MadeWithoutBrush",
                 [] {
                   json members = made_with(json::object());
                   members["brush"] = nullptr;
                   return members;
                 }(),
                 ": lacks 'brush'"},
        BadSuite{"MadeOfOneSample", made_with({{"samples", 1}}), ".stroke.samples: must be a whole number"},
        BadSuite{"MadeFromTwoNumbers", made_with({{"from", {1, 2}}}), ".stroke.from: must be three numbers"},
        BadSuite{"MadeOnTheSpot", made_with({{"towards", {0, 0, 1}}}), ".stroke: 'from' and 'towards' are"}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(BenchSuite, TellsTheLineOfBrokenJson) {
  const BenchFolder folder;
  const std::string suite = folder.write("broken.json", "{\"burin_suite\": 1,\n\"name\": oops}\n");
  const ProcessResult result = burin({"bench", suite});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err, "burin: " + suite + ":2: malformed JSON at column 9\n");
}

TEST(BenchSuite, TakesThoseOfTheSamples) {
  for (const char* name : {"everyday", "scaling"}) {
    const std::string suite = std::string(BURIN_SAMPLES "/suites/") + name + ".json";
    // Looked for among the cases once the whole suite is found sound.
    EXPECT_EQ(burin({"bench", suite, "--case", "none"}).err, "burin: " + suite + ": has no case 'none'\n");
  }
}

TEST(BenchSuite, SaysWhatTheBrushRefuses) {
  const BenchFolder folder;
  const std::string suite =
      folder.write_suite({BenchFolder::bench_case("a", {{"brush", "org.none"}, {"repeat", 1}})});
  const ProcessResult result = burin({"bench", suite});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("a.stroke: stroke 1: "), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("org.none"), std::string::npos) << result.err;
}

TEST(BenchSuite, RefusesAMadeStrokeThatWouldNotEnd) {
  const BenchFolder folder;
  for (const double length : {1e308, 1e9}) {
    json one = BenchFolder::bench_case("a");
    one.merge_patch(made_with({{"length_radii", length}}));
    const std::string suite = folder.write_suite({one});
    const ProcessResult result = burin({"bench", suite});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("edges long; at most 1e+07 are walked"), result.err.npos) << result.err;
  }
}

}  // namespace
}  // namespace burin::test
