#include <burin/base/file.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "../run_command.h"

namespace burin::test {
namespace {

namespace fs = std::filesystem;

/// Fuzzes a plugin until it fails, at most for four minutes.
ProcessResult fuzz(const std::string& module, const std::string& seed, const std::string& bundle) {
  return burin({"validate", module, "--fuzz", "4", "--seed", seed, "--bundle", bundle});
}

nlohmann::json description(const std::string& bundle) {
  return nlohmann::json::parse(read_file(bundle + "/bundle.json"));
}

std::uintmax_t bytes_in(const std::string& folder) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::directory_iterator(folder)) bytes += entry.file_size();
  return bytes;
}

TEST(Fuzz, ShrinksAFailureToWhatItNeeds) {
  const CommandFolder folder;
  const std::string bundle = folder.path("bundle");
  const ProcessResult result = fuzz(bad_plugin("fuzz.rare-number"), "14", bundle);
  EXPECT_EQ(result.exit_code, 1) << result.out << result.err;
  EXPECT_NE(result.out.find("returned a displacement that is not finite"), std::string::npos) << result.out;
  EXPECT_TRUE(result.out.ends_with("burin replay " + bundle + "\n")) << result.out;
  const nlohmann::json settings = description(bundle)["settings"];
  EXPECT_EQ(settings.size(), 3u) << settings;
  EXPECT_EQ(settings["params"], (nlohmann::json{{"count", 7.0}, {"profile", "flat"}}));
  EXPECT_LE(bytes_in(bundle), 10'000u);
}

TEST(Fuzz, RepeatsAFailureWhereverTheBundleLies) {
  const CommandFolder folder;
  fuzz(bad_plugin("fuzz.rare-end"), "1", folder.path("bundle"));
  fs::create_directory(folder.path("elsewhere"));
  const std::string moved = folder.path("elsewhere/moved");
  fs::rename(folder.path("bundle"), moved);
  const ProcessResult again = burin({"replay", moved});
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_NE(again.err.find("fails again: org.example.good: drawn whole at its end the stroke differs"),
            std::string::npos)
      << again.err;
  // By itself the stroke can be drawn, too.
  EXPECT_EQ(burin({"replay", moved + "/stroke.stroke", "--mesh", moved + "/surface.ply", "--brush",
                   "org.burin.groove"})
                .exit_code,
            0);
}

TEST(Fuzz, TellsOfABundleWhosePluginWasMended) {
  const CommandFolder folder;
  const std::string module = folder.path("mine.burin"), bundle = folder.path("bundle");
  fs::copy_file(bad_plugin("fuzz.rare-end"), module);
  fuzz(module, "1", bundle);
  fs::copy_file(bad_plugin("good"), module, fs::copy_options::overwrite_existing);
  const ProcessResult again = burin({"replay", bundle});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(again.out.ends_with("does not fail any more\n")) << again.out;
  fs::remove(module);
  EXPECT_EQ(burin({"replay", bundle}).err,
            "burin: " + module + ": is not there; bundle.json names the module\n");
}

TEST(Fuzz, FindsCrashes) {
  const CommandFolder folder;
  const std::string bundle = folder.path("bundle");
  const ProcessResult result = fuzz(bad_plugin("fuzz.rare-crash"), "15", bundle);
  EXPECT_NE(result.out.find(": Aborted\n"), std::string::npos) << result.out;
  EXPECT_EQ(description(bundle)["settings"]["closed"], "yes");
  EXPECT_EQ(burin({"replay", bundle}).err, "burin: brush org.example.good crashed: abort\n");
}

TEST(Fuzz, ShrinksATrialThatHangs) {
  const CommandFolder folder;
  const std::string bundle = folder.path("bundle"), module = bad_plugin("fuzz.rare-hang");
  const ProcessResult result =
      burin({"validate", module, "--fuzz", "4", "--seed", "15", "--time-limit", "4", "--bundle", bundle});
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_NE(result.out.find("did not end within 4 seconds"), std::string::npos) << result.out;
  const nlohmann::json settings = description(bundle)["settings"];
  EXPECT_EQ(settings.size(), 4u) << settings;
  EXPECT_EQ(settings["closed"], "yes");
  EXPECT_EQ(settings["params"].size(), 1u);
  EXPECT_GT(settings["params"]["count"], 6);
  EXPECT_LE(bytes_in(bundle), 10'000u);
  const ProcessResult again = burin({"replay", bundle});
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_NE(again.out.find("time limit: 4 seconds"), std::string::npos) << again.out;
  EXPECT_EQ(again.err, "burin: fails again: did not end within 4 seconds\n");
}

TEST(Fuzz, TriesTheSameWithTheSameSeed) {
  const CommandFolder folder;
  fuzz(bad_plugin("fuzz.rare-end"), "3", folder.path("one"));
  fuzz(bad_plugin("fuzz.rare-end"), "3", folder.path("two"));
  fuzz(bad_plugin("fuzz.rare-end"), "4", folder.path("three"));
  for (const char* file : {"/stroke.stroke", "/surface.ply", "/bundle.json"}) {
    EXPECT_EQ(read_file(folder.path("one") + file), read_file(folder.path("two") + file)) << file;
  }
  EXPECT_NE(read_file(folder.path("one/stroke.stroke")), read_file(folder.path("three/stroke.stroke")));
}

TEST(Fuzz, FindsNoFaultWhereThereIsNone) {
  const CommandFolder folder;
  const ProcessResult result =
      burin({"validate", bad_plugin("good"), "--fuzz", "0.01", "--bundle", folder.path("bundle")});
  EXPECT_EQ(result.exit_code, 0) << result.out;
  EXPECT_NE(result.out.find(" trials, none failed, "), std::string::npos) << result.out;
}

TEST(Fuzz, TellsWhyABrushRefusesToBegin) {
  const CommandFolder folder;
  const std::string scales =
      (std::filesystem::path(BURIN_COMMAND).parent_path() / "brushes/scales.burin").string();
  // Half of the files that are tried are no images.
  const ProcessResult result =
      burin({"validate", scales, "--fuzz", "0.02", "--bundle", folder.path("bundle")});
  EXPECT_NE(result.out.find(" refused, the last since stroke 1: org.burin.scales: "), std::string::npos)
      << result.out;
}

TEST(Fuzz, RefusesWrongUse) {
  const CommandFolder folder;
  EXPECT_EQ(burin({"validate", bad_plugin("good"), "--fuzz", "0"}).exit_code, 2);
  EXPECT_EQ(burin({"validate", bad_plugin("good"), "--bundle", folder.path("a")}).exit_code, 2);
  EXPECT_EQ(burin({"validate", bad_plugin("good"), "--fuzz", "1", "--json"}).exit_code, 2);
  EXPECT_EQ(burin({"validate", folder.write("a.burin", "text"), "--fuzz", "1"}).exit_code, 2);
  fs::create_directory(folder.path("empty"));
  EXPECT_EQ(burin({"replay", folder.path("empty")}).exit_code, 2);
}

}  // namespace
}  // namespace burin::test
