#include "../sessions.h"
#include "support/shared_data.h"

#include <burin/base/error.h>
#include <burin/host/plugin/search_path.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace burin {
namespace {
namespace fs = std::filesystem;

TEST(SearchPath, SplitsTheVariable) {
  setenv("BURIN_PLUGIN_PATH", "/one::/two words:", 1);
  EXPECT_EQ(plugin_search_path(), (std::vector<fs::path>{"/one", "/two words"}));
  unsetenv("BURIN_PLUGIN_PATH");
  EXPECT_TRUE(plugin_search_path().empty());
}

TEST(SearchPath, ListsPluginsByName) {
  const test::TemporaryFolder folder;
  for (const char* name : {"b.burin", "a.burin", "c.so"}) std::ofstream(folder.path() / name) << "x";
  EXPECT_EQ(plugin_files(folder.path()),
            (std::vector<fs::path>{folder.path() / "a.burin", folder.path() / "b.burin"}));
}

TEST(SearchPath, TellsLibrariesThatArePluginsByTheirSymbol) {
  const test::TemporaryFolder folder;
  const fs::path plugin = folder.path() / "plugin.so";
  fs::copy_file(test::brushes_folder / "groove.burin", plugin);
  fs::copy_file(test::test_plugins_folder / "no_symbol.burin", folder.path() / "library.so");
  std::ofstream(folder.path() / "notes.txt") << std::string("\0burin_plugin\0", 14);
  EXPECT_EQ(misnamed_plugins(folder.path()), std::vector<fs::path>{plugin});
}

TEST(SearchPath, NamesAFolderThatIsMissing) {
  try {
    plugin_files("/no/such/folder");
    FAIL();
  } catch (const FileError& error) {
    EXPECT_EQ(std::string(error.what()),
              "/no/such/folder: plugins cannot be listed: No such file or directory");
  }
}

}  // namespace
}  // namespace burin
