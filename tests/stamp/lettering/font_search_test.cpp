#include <burin/base/error.h>
#include <burin/stamp/lettering/font_search.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "support/shared_data.h"

namespace burin {
namespace {

namespace fs = std::filesystem;

/// Two folders of fonts, user's and system's.
class FontSearch : public ::testing::Test {
 protected:
  fs::path plant(const fs::path& name) {
    const fs::path path = folder_.path() / name;
    fs::create_directories(path.parent_path());
    std::ofstream(path) << "a font";
    return path;
  }
  fs::path find(const fs::path& font) {
    return find_font(font, {folder_.path() / "none", folder_.path() / "user", folder_.path() / "system"});
  }
  std::string complaint(const fs::path& font) {
    try {
      find(font);
    } catch (const Error& error) {
      return error.what();
    }
    return "found";
  }

  test::TemporaryFolder folder_;
};

TEST_F(FontSearch, TakesAPathAsItIs) {
  const fs::path font = plant("elsewhere/a.ttf");
  plant("user/a.ttf");
  EXPECT_EQ(find(font), font);
}

TEST_F(FontSearch, FindsANameBelowTheFirstFolderThatHasIt) {
  plant("system/a.ttf");
  EXPECT_EQ(find("a.ttf"), folder_.path() / "system/a.ttf");
  const fs::path users = plant("user/deep/down/a.ttf");
  EXPECT_EQ(find("a.ttf"), users);
}

TEST_F(FontSearch, TakesTheFirstInTheOrderOfPaths) {
  for (const char* name : {"user/m/a.ttf", "user/z/a.ttf", "user/b/c/a.ttf", "user/q/a.ttf"}) plant(name);
  EXPECT_EQ(find("a.ttf"), folder_.path() / "user/b/c/a.ttf");
}

TEST_F(FontSearch, NamesTheFoldersWhereItLooked) {
  plant("user/other.ttf");
  fs::create_directories(folder_.path() / "user/folder.ttf");
  const std::string in = folder_.path().string();
  for (const char* name : {"a.ttf", "folder.ttf"})
    EXPECT_EQ(complaint(name), std::string(name) + ": there is no such font, neither here nor in " + in +
                                   "/none, " + in + "/user, " + in + "/system");
  EXPECT_EQ(complaint("sub/other.ttf"), "sub/other.ttf: there is no such font file");
  EXPECT_EQ(complaint(""), "no font is named");
}

TEST_F(FontSearch, KnowsTheSystemsFolders) {
  const std::vector<fs::path> folders = system_font_folders();
  ASSERT_FALSE(folders.empty());
  for (const fs::path& folder : folders) EXPECT_TRUE(folder.is_absolute()) << folder;
  EXPECT_TRUE(fs::is_regular_file(find_font("DejaVuSans.ttf")));
}

}  // namespace
}  // namespace burin
