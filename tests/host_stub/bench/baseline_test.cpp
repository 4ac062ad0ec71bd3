#include <burin/base/file.h>
#include <gtest/gtest.h>

#include "bench_suite.h"

namespace burin::test {
namespace {

using nlohmann::json;

/// A suite, and the baseline that the command wrote for it.
struct Baseline {
  BenchFolder folder;
  std::string suite = folder.write_suite({BenchFolder::bench_case("a"), BenchFolder::bench_case("b")});
  std::string path = folder.path("baseline.json");

  Baseline() { burin_json({"bench", suite, "--repeat", "1", "--write-baseline", path}); }

  json read() const { return json::parse(read_file(path)); }

  ProcessResult check(const json& baseline) const {
    folder.write("baseline.json", baseline.dump());
    return burin({"bench", suite, "--repeat", "1", "--json", "--baseline", path});
  }
};

TEST(BenchBaseline, HoldsWhatEveryMachineGives) {
  const Baseline baseline;
  const json written = baseline.read();
  EXPECT_EQ(written["burin_baseline"], 1);
  EXPECT_EQ(written["suite"], "small");
  ASSERT_EQ(written["cases"].size(), 2u);
  EXPECT_EQ(written["cases"][0].size(), 3u) << "name, hash and counters alone";
  EXPECT_EQ(written["cases"][0]["counters"]["events"], 41);
  const ProcessResult same = baseline.check(written);
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_EQ(same.err, "");
}

TEST(BenchBaseline, FailsOnACounterOrHashThatDiffers) {
  const Baseline baseline;
  json edited = baseline.read();
  const std::string moved = edited["cases"][0]["counters"]["moved"].dump(), hash = edited["cases"][1]["hash"];
  edited["cases"][0]["counters"]["moved"] = 7;
  edited["cases"][1]["hash"] = "0123456789abcdef";
  const ProcessResult result = baseline.check(edited);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.err, "burin: a: moved: was 7, is " + moved +
                            "\nburin: b: hash: was 0123456789abcdef, is " + hash +
                            "\nburin: " + baseline.path + ": 2 differences\n");
  EXPECT_EQ(json::parse(result.out)["cases"].size(), 2u) << "the result is told all the same";
}

TEST(BenchBaseline, FailsOnCasesThatOnlyOneSideHas) {
  const Baseline baseline;
  json edited = baseline.read();
  edited["cases"][1]["name"] = "c";
  const ProcessResult result = baseline.check(edited);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("burin: c: was measured, is absent\n"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("burin: b: was absent, is measured\n"), std::string::npos) << result.err;
}

TEST(BenchBaseline, RefusesThatOfAnotherSuite) {
  const Baseline baseline;
  json edited = baseline.read();
  edited["suite"] = "large";
  EXPECT_EQ(baseline.check(edited).exit_code, 2);
  EXPECT_EQ(baseline.check(json::object()).exit_code, 2);
}

TEST(BenchBaseline, OfTheSamplesHolds) {
  // The small cases; `./dev bench` measures all.
  const std::string suites = BURIN_SAMPLES "/suites/";
  const CommandFolder folder;
  std::vector<std::string> command = {"bench", suites + "everyday.json", "--repeat", "1"};
  json known = json::parse(read_file(suites + "baseline.json"));
  json kept = json::array();
  for (const json& one : known["cases"]) {
    if (one["counters"]["triangles"] > 400000) continue;
    kept.push_back(one);
    command.insert(command.end(), {"--case", one["name"]});
  }
  ASSERT_EQ(kept.size(), 4u);
  known["cases"] = kept;
  folder.write("baseline.json", known.dump());
  command.insert(command.end(), {"--baseline", folder.path("baseline.json")});
  const ProcessResult result = burin(command);
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

}  // namespace
}  // namespace burin::test
