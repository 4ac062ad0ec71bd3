#include <gtest/gtest.h>

#include "bench_suite.h"

namespace burin::test {
namespace {

using nlohmann::json;

const json stages = {"pick", "curve", "chart", "evaluate", "blend", "move", "record"};

void expect_rising(const json& figures) {
  EXPECT_GE(figures["p50"], 0);
  EXPECT_LE(figures["p50"], figures["p95"]);
  EXPECT_LE(figures["p95"], figures["p99"]);
  EXPECT_LE(figures["p99"], figures["max"]);
  EXPECT_LE(figures["mean"], figures["max"]);
}

TEST(BenchCommand, TellsWhatItMeasured) {
  const BenchFolder folder;
  const json result = burin_json({"bench", folder.write_suite({BenchFolder::bench_case("a")})});
  EXPECT_EQ(result["burin_bench"], 1);
  EXPECT_EQ(result["suite"], "small");
  const json& one = result["cases"].at(0);
  EXPECT_EQ(one["name"], "a");
  EXPECT_EQ(one["event_ms"]["count"], 3 * 41) << "three repeats unless the suite says otherwise";
  EXPECT_EQ(one["end_ms"]["count"], 3);
  EXPECT_EQ(one["undo_ms"]["count"], 3);
  EXPECT_EQ(one["stroke_s"].size(), 3u);
  EXPECT_EQ(one["distribution_ms"].size(), 101u);
  EXPECT_EQ(one["distribution_ms"].back(), one["event_ms"]["max"]);
  double sum = 0;
  for (const json& stage : stages) {
    expect_rising(one["event_ms"]["stages"][stage]);
    sum += one["event_ms"]["stages"][stage]["mean"].get<double>();
  }
  expect_rising(one["event_ms"]);
  EXPECT_NEAR(sum, one["event_ms"]["mean"], 0.2 * sum) << "the stages are nearly all of an event";
  EXPECT_GT(one["load_s"], 0);
  EXPECT_GT(one["seconds_to_first_event"], one["load_s"]);
  EXPECT_GT(one["vertices_per_second"], 1000);
  EXPECT_GT(one["memory"]["ready_bytes_per_vertex"], 50);
  EXPECT_GE(one["memory"]["peak_bytes"], one["memory"]["ready_bytes"]);
  const json& counters = one["counters"];
  EXPECT_EQ(counters["vertices"], 2562);
  EXPECT_EQ(counters["triangles"], 5120);
  EXPECT_EQ(counters["events"], 41);
  EXPECT_EQ(counters["pieces"], 1);
  for (const char* name : {"settled", "pushes", "evaluated"}) EXPECT_TRUE(counters.contains(name)) << name;
  EXPECT_GT(counters["region"], 100);
  EXPECT_LT(counters["region"], 150) << "a band of 0.4 by 1.2 and its caps on a sphere of 4 pi";
  EXPECT_GT(counters["moved"], counters["region"]);
  EXPECT_GT(counters["surface_bytes"], 2562 * 24 + 5120 * 12);
}

TEST(BenchCommand, GivesTheHashOfReplayAndTheSameCountersAgain) {
  const BenchFolder folder;
  const std::string suite = folder.write_suite({BenchFolder::bench_case("a", {{"strength", 0.5}})});
  const json first = burin_json({"bench", suite})["cases"][0];
  const json again = burin_json({"bench", suite, "--repeat", "1"})["cases"][0];
  const json replayed = burin_json(
      {"replay", folder.path("a.stroke"), "--mesh", folder.path("sphere.obj"), "--strength", "0.5"});
  EXPECT_EQ(first["hash"], replayed["result_hash"]);
  EXPECT_EQ(first["hash"], again["hash"]);
  EXPECT_EQ(first["counters"], again["counters"]);
  EXPECT_EQ(again["event_ms"]["count"], 41);
}

TEST(BenchCommand, RunsTheCasesThatAreAskedFor) {
  const BenchFolder folder;
  const std::string suite = folder.write_suite({BenchFolder::bench_case("a"), BenchFolder::bench_case("b"),
                                                BenchFolder::bench_case("c", {{"radius", 0.1}})});
  const json two = burin_json({"bench", suite, "--case", "c", "--case", "a", "--repeat", "1"})["cases"];
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0]["name"], "c");
  EXPECT_EQ(two[1]["name"], "a");
  EXPECT_LT(two[0]["counters"]["region"], two[1]["counters"]["region"]);
  const ProcessResult unknown = burin({"bench", suite, "--case", "d"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_EQ(unknown.err, "burin: " + suite + ": has no case 'd'\n");
}

TEST(BenchCommand, SaysTheSameAsText) {
  const BenchFolder folder;
  const std::string suite = folder.write_suite({BenchFolder::bench_case("a"), BenchFolder::bench_case("b")});
  const std::string text = burin_output({"bench", suite, "--repeat", "1"});
  const std::string hash = burin_json({"bench", suite, "--repeat", "1"})["cases"][0]["hash"];
  for (const std::string& word : {std::string("p99 ms"), std::string("chart"), std::string("5120"), hash})
    EXPECT_NE(text.find(word), std::string::npos) << word << " in\n" << text;
}

TEST(BenchCommand, FindsStampsFromTheFolderOfTheSuite) {
  const BenchFolder folder;
  std::filesystem::create_directory(folder.path("stamps"));
  std::filesystem::copy(BURIN_SAMPLES "/stamps/scales.exr", folder.path("stamps/s.exr"));
  const std::string suite = folder.write_suite({BenchFolder::bench_case(
      "a", {{"brush", "org.burin.scales"}, {"params", {{"stamp", "stamps/s.exr"}}}, {"repeat", 1}})});
  const json replayed =
      burin_json({"replay", folder.path("a.stroke"), "--mesh", folder.path("sphere.obj"), "--brush",
                  "org.burin.scales", "--param", "stamp=" + folder.path("stamps/s.exr")});
  EXPECT_EQ(burin_json({"bench", suite})["cases"][0]["hash"], replayed["result_hash"]);
}

TEST(BenchCommand, TakesTextAndTheFilesThatMayBeLeftOut) {
  const BenchFolder folder;
  const auto benched = [&](const json& members) {
    json all = {{"repeat", 1}};
    all.update(members);
    return burin_json({"bench", folder.write_suite({BenchFolder::bench_case("a", all)})})["cases"][0]["hash"];
  };
  const auto replayed = [&](std::vector<std::string> options) {
    options.insert(options.begin(),
                   {"replay", folder.path("a.stroke"), "--mesh", folder.path("sphere.obj"), "--brush"});
    return burin_json(options)["result_hash"];
  };
  const std::string stamp = BURIN_SAMPLES "/stamps/scales.exr";
  std::filesystem::copy(stamp, folder.path("s.exr"));
  EXPECT_EQ(benched({{"brush", "org.burin.tread"}, {"params", {{"stamp", "s.exr"}, {"end_stamp", ""}}}}),
            replayed({"org.burin.tread", "--param", "stamp=" + stamp, "--param", "end_stamp="}));
  EXPECT_EQ(benched({{"brush", "org.burin.text"}, {"params", {{"text", "Ä 7"}}}}),
            replayed({"org.burin.text", "--param", "text=Ä 7"}));
}

TEST(BenchCommand, NeedsASuiteOrAHistoryToReport) {
  EXPECT_EQ(burin({"bench"}).exit_code, 2);
  EXPECT_EQ(burin({"bench", "none.json"}).exit_code, 2);
  EXPECT_EQ(burin({"bench", "--history", "none.json"}).exit_code, 2);
}

}  // namespace
}  // namespace burin::test
