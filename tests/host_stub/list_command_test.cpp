#include <gtest/gtest.h>

#include "run_command.h"

namespace burin::test {
namespace {

using nlohmann::json;

json find(const json& list, const std::string& id) {
  for (const json& entry : list) {
    if (entry["id"] == id) return entry;
  }
  return nullptr;
}

TEST(ListCommand, ListsTheStockBrushesWithTheirParameters) {
  const json brushes = burin_json({"list"})["brushes"];
  const json groove = find(brushes, "org.burin.groove");
  ASSERT_FALSE(groove.is_null());
  EXPECT_NE(groove["version"], "");
  EXPECT_TRUE(std::filesystem::is_regular_file(groove["module"].get<std::string>()));
  EXPECT_EQ(groove["overlap"], "strongest");
  EXPECT_EQ(find(brushes, "org.burin.bark")["overlap"], "latest");
  const json depth = find(groove["params"], "depth");
  ASSERT_FALSE(depth.is_null());
  EXPECT_EQ(depth["type"], "float");
  EXPECT_GE(depth["default"], depth["range"][0]);
  EXPECT_LE(depth["default"], depth["range"][1]);
  const json scales = find(brushes, "org.burin.scales");
  ASSERT_FALSE(scales.is_null());
  bool takes_a_file = false;
  for (const json& param : scales["params"]) takes_a_file = takes_a_file || param["type"] == "file";
  EXPECT_TRUE(takes_a_file);
}

TEST(ListCommand, TellsWhichParametersAreDynamicAndNumbersAsTheyWereWritten) {
  const std::string text = burin_output({"list"});
  const json crease = find(burin_json({"list"})["brushes"], "org.burin.crease");
  EXPECT_EQ(find(crease["params"], "pinch")["default"].dump(), "0.3");
  EXPECT_EQ(find(crease["params"], "pinch")["dynamic"], true);
  EXPECT_EQ(find(crease["params"], "taper")["dynamic"], false);
  EXPECT_NE(text.find("default 0.3        dynamic "), std::string::npos);
}

TEST(ListCommand, TellsOfTextParameters) {
  const json params = find(burin_json({"list"})["brushes"], "org.burin.text")["params"];
  const json text = find(params, "text");
  ASSERT_FALSE(text.is_null());
  EXPECT_EQ(text["type"], "text");
  EXPECT_EQ(text["default"], "Burin");
  EXPECT_FALSE(text.contains("range"));
}

TEST(ListCommand, NamesEveryParameterInItsText) {
  const std::string text = burin_output({"list"});
  EXPECT_NE(text.find("\n  overlap: strongest\n"), std::string::npos);
  const json brushes = burin_json({"list"})["brushes"];
  for (const json& brush : brushes) {
    EXPECT_NE(text.find(brush["id"].get<std::string>()), std::string::npos);
    for (const json& param : brush["params"]) {
      EXPECT_NE(text.find("    " + param["id"].get<std::string>() + " "), std::string::npos) << param["id"];
    }
  }
}

TEST(ListCommand, ListsWhatIsNamed) {
  const json all = burin_json({"list"})["brushes"], one = burin_json({"list", "org.burin.wave"})["brushes"];
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0], find(all, "org.burin.wave"));
  EXPECT_EQ(burin_json({"list", one[0]["module"]})["brushes"], one);
  EXPECT_EQ(burin({"list", "org.burin.nobody"}).exit_code, 2);
}

TEST(ListCommand, WarnsOfAModuleThatIsNone) {
  const CommandFolder folder;
  const std::string module =
      folder.write("broken.burin", "This is a text and not a shared module, whatever its name says.\n");
  const ProcessResult result = run_process({BURIN_COMMAND, "list"}, {"BURIN_PLUGIN_PATH=" + folder.path("")});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, burin_output({"list"}));
  EXPECT_EQ(result.err, "burin: warning: " + module + ": invalid ELF header\n");
}

}  // namespace
}  // namespace burin::test
