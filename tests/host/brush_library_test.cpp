#include "sessions.h"
#include "support/shared_data.h"

#include <burin/abi/ext/log.h>
#include <burin/abi/plugin.h>
#include <burin/host/brush_library.h>

#include <fstream>

namespace burin {
namespace {
namespace fs = std::filesystem;

/// The line that loading this test plugin fails with, less the path that it must begin with.
std::string load_error(const std::string& name) {
  BrushLibrary library;
  const fs::path path = test::test_plugins_folder / (name + ".burin");
  const std::string line = test::error_of([&] { library.load(path); });
  EXPECT_TRUE(library.brushes().empty());
  EXPECT_EQ(line.find(path.string() + ": "), 0u) << line;
  return line.substr(std::min(line.size(), path.string().size() + 2));
}

TEST(BrushLibrary, LoadsTheStockBrushesByName) {
  BrushLibrary library;
  library.load_folder(test::brushes_folder);
  const std::vector<BrushEntry>& brushes = library.brushes();
  ASSERT_GT(brushes.size(), 1u);
  for (std::size_t i = 1; i < brushes.size(); ++i) EXPECT_LT(brushes[i - 1].module, brushes[i].module);
  EXPECT_EQ(library.find("org.burin.groove").module, test::brushes_folder / "groove.burin");
  EXPECT_STREQ(library.find("org.burin.scales").descriptor->id, "org.burin.scales");
  EXPECT_TRUE(library.create(library.find("org.burin.groove")));
}

TEST(BrushLibrary, NamesTheBrushesThereAre) {
  BrushLibrary library;
  EXPECT_EQ(test::error_of([&] { library.find("org.burin.none"); }),
            "no brush 'org.burin.none'; there are: none");
  for (const char* name : {"groove.burin", "scales.burin"}) library.load(test::brushes_folder / name);
  EXPECT_EQ(test::error_of([&] { library.find("groove"); }),
            "no brush 'groove'; there are: org.burin.groove, org.burin.scales");
}

TEST(BrushLibrary, SaysWhatIsWrongWithAModule) {
  EXPECT_EQ(load_error("missing"), "cannot open shared object file: No such file or directory");
  EXPECT_EQ(load_error("no_symbol"), "is no Burin plugin: it does not export 'burin_plugin'");
  EXPECT_EQ(load_error("wrong_major"), "is made for version 999 of the plugin interface, not for 1");
  EXPECT_EQ(load_error("init_fails"), "cannot be initialised: no licence");
  EXPECT_EQ(load_error("broken_descriptor"), "a brush's id is no reverse DNS name such as org.example.brush");
  EXPECT_EQ(load_error("broken_params"),
            "brush org.burin.test.broken-params: counts parameters but lists none");
}

TEST(BrushLibrary, RefusesWhatIsNoModule) {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "text.burin";
  std::ofstream(path) << "This is a text and not a shared module, whatever its name says.\n";
  BrushLibrary library;
  const std::string line = test::error_of([&] { library.load(path); });
  EXPECT_EQ(line, path.string() + ": invalid ELF header");
}

TEST(BrushLibrary, RefusesABrushThatIsThere) {
  BrushLibrary library;
  const test::TemporaryFolder folder;
  const fs::path groove = test::brushes_folder / "groove.burin", copy = folder.path() / "copy.burin";
  library.load(groove);
  fs::copy_file(groove, copy);
  EXPECT_EQ(test::error_of([&] { library.load(copy); }),
            copy.string() + ": brush org.burin.groove is already there, from " + groove.string());
  EXPECT_EQ(library.brushes().size(), 1u);
}

TEST(BrushLibrary, TakesOneModuleUnderTwoNamesOnce) {
  BrushLibrary library;
  library.load(test::brushes_folder / "groove.burin");
  library.load(test::brushes_folder / ".." / test::brushes_folder.filename() / "groove.burin");
  EXPECT_EQ(library.brushes().size(), 1u);
}

TEST(BrushLibrary, RefusesABrushThatReadsWhatIsNotOffered) {
  BrushLibrary library;
  const fs::path greedy = test::test_plugins_folder / "greedy_brush.burin";
  library.load(greedy);
  EXPECT_EQ(test::error_of([&] { library.create(library.brushes().at(0)); }),
            greedy.string() + ": brush org.burin.test.greedy reads what this host does not offer: number 40");
}

std::vector<std::string> warnings;

TEST(BrushLibrary, WarnsOfBrokenModulesInAFolderUnlessTheirBrushesAreAskedFor) {
  const test::TemporaryFolder folder;
  const std::string broken = (folder.path() / "a_broken.burin").string(),
                    copy = (folder.path() / "z_copy.burin").string();
  std::ofstream(broken) << "This is a text and not a shared module, whatever its name says.\n";
  for (const char* name : {"groove.burin", "scales.burin"})
    fs::copy(test::brushes_folder / name, folder.path());
  fs::copy(test::brushes_folder / "groove.burin", copy);
  warnings.clear();
  BrushLibrary library([](int severity, std::string_view line) {
    warnings.push_back(std::to_string(severity) + " " + std::string(line));
  });
  library.load_folder(folder.path());
  const std::string no_module = broken + ": invalid ELF header",
                    twice = copy + ": brush org.burin.groove is already there, from " +
                            (folder.path() / "groove.burin").string();
  const std::string severity = std::to_string(BURIN_LOG_WARNING) + " ";
  EXPECT_EQ(warnings, (std::vector<std::string>{severity + no_module, severity + twice}));
  EXPECT_EQ(library.brushes().size(), 2u);
  EXPECT_STREQ(library.find("org.burin.scales").descriptor->id, "org.burin.scales");
  EXPECT_EQ(test::error_of([&] { library.find("org.burin.groove"); }), twice) << "which of the two?";
  EXPECT_EQ(test::error_of([&] { library.find("org.burin.broken"); }),
            "no brush 'org.burin.broken'; there are: org.burin.groove, org.burin.scales; not loaded: " +
                no_module + "; not loaded: " + twice);
}

TEST(BrushLibrary, WarnsOfAPluginThatIsNamedAsALibrary) {
  const test::TemporaryFolder folder;
  const fs::path library_file = folder.path() / "groove.so";
  fs::copy(test::brushes_folder / "groove.burin", library_file);
  warnings.clear();
  BrushLibrary library([](int, std::string_view line) { warnings.emplace_back(line); });
  library.load_folder(folder.path());
  const std::string line = library_file.string() + ": is a plugin, but only files named *.burin are loaded";
  EXPECT_EQ(warnings, std::vector<std::string>{line});
  EXPECT_EQ(test::error_of([&] { library.find("org.burin.groove"); }),
            "no brush 'org.burin.groove'; there are: none; not loaded: " + line);
}

TEST(BrushLibrary, SearchesTheEnvironmentFirst) {
  const test::TemporaryFolder folder;
  fs::copy(test::test_plugins_folder / "nan_brush.burin", folder.path());
  setenv("BURIN_PLUGIN_PATH", folder.path().c_str(), 1);
  BrushLibrary library;
  library.load_search_path(test::brushes_folder);
  unsetenv("BURIN_PLUGIN_PATH");
  ASSERT_GT(library.brushes().size(), 2u);
  EXPECT_STREQ(library.brushes()[0].descriptor->id, "org.burin.test.nan");

  BrushLibrary alone;
  alone.load_search_path(folder.path() / "missing");
  EXPECT_TRUE(alone.brushes().empty());
}

}  // namespace
}  // namespace burin
