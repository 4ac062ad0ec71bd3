#include <burin/base/file.h>
#include <gtest/gtest.h>

#include "bench_suite.h"
#include "host_stub/picture_file.h"

namespace burin::test {
namespace {

using nlohmann::json;

json made(const std::string& name, double radius_edges, int level, const char* axis) {
  return {{"name", name},
          {"mesh", "cube.obj"},
          {"subdivide", level},
          {"stroke", {{"samples", 20}, {"from", {0.1, 0, 1}}, {"towards", {1, 0.3, 1}}, {"length_radii", 4}}},
          {"brush", "org.burin.groove"},
          {"radius_edges", radius_edges},
          {"repeat", 2},
          {"axis", axis}};
}

/// A recorded case and four that scale, <-- with a name that HTML must escape. Writes a mesh into the folder.
json measured(const BenchFolder& folder, const std::vector<std::string>& options = {}) {
  folder.write("cube.obj", cube_obj());
  std::vector<std::string> command = {
      "bench", folder.write_suite({BenchFolder::bench_case("a <b> 'c'"), made("small region", 3, 5, "region"),
                                   made("large region", 12, 5, "region"), made("coarse", 5, 4, "mesh"),
                                   made("fine", 5, 6, "mesh")})};
  command.insert(command.end(), options.begin(), options.end());
  return burin_json(command);
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// The page without its pictures, whose bytes it must hold, and how many they were.
std::pair<std::string, std::size_t> without_pictures(std::string page) {
  const std::string begin = "src='data:image/png;base64,";
  std::size_t pictures = 0;
  for (std::size_t at = page.find(begin); at != std::string::npos; at = page.find(begin, at), ++pictures)
    page.erase(at, page.find('\'', at + begin.size()) - at);
  return {page, pictures};
}

TEST(BenchReport, IsOnePageThatNeedsNothingElse) {
  const BenchFolder folder;
  const std::string report = folder.path("report");
  const json told = measured(folder, {"--report", report});
  EXPECT_EQ(json::parse(read_file(report + "/result.json")), told);
  const auto [html, pictures] = without_pictures(read_file(report + "/index.html"));
  EXPECT_EQ(pictures, 5u) << "one a case";
  for (int number = 1; number <= 5; ++number) {
    const Picture picture = read_png(report + "/pictures/" + std::to_string(number) + ".png");
    EXPECT_TRUE(covered(picture, picture.width / 2, picture.height / 2)) << "looks at stroke " << number;
  }
  EXPECT_NE(html.find("exponent"), std::string::npos);
  for (const char* foreign : {"http", "src=", "href=", "@import", "url(", "<script"})
    EXPECT_EQ(html.find(foreign), std::string::npos) << foreign;
  EXPECT_EQ(html.find("<b>"), std::string::npos);
  EXPECT_NE(html.find("a &lt;b> &#39;c&#39;"), std::string::npos);
  EXPECT_EQ(count(html, "<svg"), 5u + 2u + 4u) << "distributions, stages of events and ends, growth";
  EXPECT_EQ(count(html, "<svg"), count(html, "</svg>"));
  EXPECT_EQ(html.find("nan"), std::string::npos);
}

TEST(BenchReport, PictureOfACaseIsThatOfTheReplay) {
  const BenchFolder folder;
  const std::string suite = folder.write_suite({BenchFolder::bench_case("a"), BenchFolder::bench_case("b")});
  const json plain = burin_json({"bench", suite, "--case", "a"})["cases"][0];
  const json drawn =
      burin_json({"bench", suite, "--case", "a", "--picture", folder.path("a.png")})["cases"][0];
  EXPECT_EQ(drawn["hash"], plain["hash"]);
  EXPECT_EQ(drawn["counters"], plain["counters"]);
  EXPECT_EQ(drawn["undo_ms"]["count"], plain["undo_ms"]["count"]);
  burin_output({"replay", folder.path("a.stroke"), "--mesh", folder.path("sphere.obj"), "--png",
                folder.path("replay.png"), "--width", "480", "--height", "360"});
  EXPECT_EQ(read_file(folder.path("a.png")), read_file(folder.path("replay.png")));
  EXPECT_EQ(burin({"bench", suite, "--picture", folder.path("b.png")}).exit_code, 2) << "of which case?";
}

TEST(BenchReport, TellsHowCostGrows) {
  const json told = measured(BenchFolder());
  const json& scaling = told["scaling"];
  ASSERT_EQ(scaling.size(), 4u);
  EXPECT_EQ(scaling[0]["axis"], "region");
  const double sizes = scaling[0]["sizes"][1].get<double>() / scaling[0]["sizes"][0].get<double>(),
               costs = scaling[0]["cost_ms"][1].get<double>() / scaling[0]["cost_ms"][0].get<double>();
  EXPECT_NEAR(sizes, 16, 3) << "four times the radius and length";
  EXPECT_NEAR(scaling[0]["exponent"], std::log(costs) / std::log(sizes), 1e-9);
  EXPECT_GT(scaling[0]["exponent"], 0.3);
  EXPECT_LT(scaling[0]["exponent"], 1.7);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_EQ(scaling[i]["axis"], "mesh");
    EXPECT_EQ(scaling[i]["sizes"], json({12 * 256, 12 * 4096}));
    EXPECT_EQ(scaling[i]["target"], 0);
  }
  const json& cases = told["cases"];
  const double coarse = cases[3]["counters"]["region"], fine = cases[4]["counters"]["region"];
  EXPECT_NEAR(fine / coarse, 1, 0.1) << "a stroke in edge lengths reaches as many vertices on a finer mesh";
}

TEST(BenchReport, ShowsTheHistoryOfSeveralResults) {
  const BenchFolder folder;
  const std::string old = folder.write("old.json", measured(folder).dump());
  const std::string report = folder.path("history");
  burin_output({"bench", "--history", old, old, old, "--report", report});
  const std::string html = read_file(report + "/index.html");
  EXPECT_EQ(count(html, "<svg"), 11u + 5u) << "a plot more for each case";
  EXPECT_EQ(count(html, "<li>"), 3u);
  EXPECT_NE(html.find("result 3: p95"), std::string::npos);
  const ProcessResult bad =
      burin({"bench", "--history", folder.path("suite.json"), "--report", folder.path("x")});
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_EQ(bad.err, "burin: " + folder.path("suite.json") + ": lacks 'burin_bench'\n");
}

}  // namespace
}  // namespace burin::test
