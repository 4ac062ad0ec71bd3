#include <burin/base/file.h>
#include <gtest/gtest.h>

#include "bench_suite.h"

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

/// A report of two recorded cases and of four that scale, <-- with a name that HTML must escape.
struct Report {
  BenchFolder folder;
  std::string path = folder.path("report");
  json told;

  Report() {
    folder.write("cube.obj", cube_obj());
    told = burin_json(
        {"bench",
         folder.write_suite({BenchFolder::bench_case("a <b> 'c'"), made("small region", 3, 5, "region"),
                             made("large region", 12, 5, "region"), made("coarse", 5, 4, "mesh"),
                             made("fine", 5, 6, "mesh")}),
         "--report", path});
  }
  std::string page() const { return read_file(path + "/index.html"); }
};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(BenchReport, IsOnePageThatNeedsNothingElse) {
  const Report report;
  EXPECT_EQ(json::parse(read_file(report.path + "/result.json")), report.told);
  const std::string html = report.page();
  for (const char* foreign : {"http", "src=", "href=", "@import", "url(", "<script"})
    EXPECT_EQ(html.find(foreign), std::string::npos) << foreign;
  EXPECT_EQ(html.find("<b>"), std::string::npos);
  EXPECT_NE(html.find("a &lt;b> &#39;c&#39;"), std::string::npos);
  EXPECT_EQ(count(html, "<svg"), 5u + 2u + 4u) << "distributions, stages of events and ends, growth";
  EXPECT_EQ(count(html, "<svg"), count(html, "</svg>"));
  EXPECT_EQ(html.find("nan"), std::string::npos);
}

TEST(BenchReport, TellsHowCostGrows) {
  const Report report;
  const json& scaling = report.told["scaling"];
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
  const json& cases = report.told["cases"];
  const double coarse = cases[3]["counters"]["region"], fine = cases[4]["counters"]["region"];
  EXPECT_NEAR(fine / coarse, 1, 0.1) << "a stroke in edge lengths reaches as many vertices on a finer mesh";
  EXPECT_NE(report.page().find("exponent"), std::string::npos);
}

TEST(BenchReport, ShowsTheHistoryOfSeveralResults) {
  const Report report;
  const std::string old = report.path + "/result.json";
  const std::string folder = report.folder.path("history");
  burin_output({"bench", "--history", old, old, old, "--report", folder});
  const std::string html = read_file(folder + "/index.html");
  EXPECT_EQ(count(html, "<svg"), 11u + 5u) << "a plot more for each case";
  EXPECT_EQ(count(html, "<li>"), 3u);
  EXPECT_NE(html.find("result 3: p95"), std::string::npos);
  const ProcessResult bad =
      burin({"bench", "--history", report.folder.path("suite.json"), "--report", report.folder.path("x")});
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_EQ(bad.err, "burin: " + report.folder.path("suite.json") + ": lacks 'burin_bench'\n");
}

}  // namespace
}  // namespace burin::test
