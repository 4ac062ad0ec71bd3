// Checks that the files which documents name or link to exist.
#include <burin/base/file.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "all_matches.h"
#include "support/shared_data.h"

namespace burin::test {
namespace {

namespace fs = std::filesystem;
using FileNames = std::vector<std::string>;

/// Paths between backquotes: a folder, and a name with an extension.
FileNames named_files(const std::string& text) {
  static const std::regex path(R"(`((?:[\w.]+/)+[\w.]+\.(?:h|cpp|txt|cmake|md|json|obj|stroke|in))`)");
  return all_matches<FileNames>(text, path);
}

FileNames linked_files(const std::string& text) {
  static const std::regex link(R"(\]\(([^)#\s:]+)(?:#[^)]*)?\))");
  return all_matches<FileNames>(text, link);
}

/// The files that a document names or links to but that do not exist. Names are relative to the root or to
/// the SDK's folders, links to the document.
FileNames missing_files(const fs::path& root, const fs::path& document) {
  const std::string text = read_file(root / document);
  FileNames missing;
  for (const std::string& name : named_files(text))
    if (!fs::exists(root / name) && !fs::exists(root / "sdk" / name) &&
        !fs::exists(root / "sdk/burin" / name))
      missing.push_back(name);
  for (const std::string& link : linked_files(text))
    if (!fs::exists(root / document.parent_path() / link)) missing.push_back(link);
  return missing;
}

TEST(Documents, NameFilesThatAreThere) {
  const fs::path root = BURIN_SOURCE_FOLDER;
  std::vector<fs::path> documents{"CONTRIBUTING.md"};
  for (const auto& entry : fs::directory_iterator(root / "docs"))
    if (entry.path().extension() == ".md") documents.push_back(fs::relative(entry.path(), root));
  EXPECT_GT(documents.size(), 7u);
  for (const fs::path& document : documents)
    EXPECT_EQ(missing_files(root, document), FileNames()) << document;
}

TEST(Documents, OfTheArchitectureNameManyFilesInFewLines) {
  const std::string text = read_file(fs::path(BURIN_SOURCE_FOLDER) / "docs/architecture.md");
  EXPECT_GT(named_files(text).size(), 80u);
  EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 200);
}

TEST(Documents, CatchFilesThatAreNot) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "sdk/burin/chart");
  fs::create_directories(folder.path() / "docs");
  std::ofstream(folder.path() / "sdk/burin/chart/front.h") << "";
  std::ofstream(folder.path() / "docs/a.md") << "`chart/front.h` and `chart/gone.h`, [a](a.md#part), "
                                                "[b](b.md), [c](https://example.org/x.md), `a.b`\n";
  EXPECT_EQ(missing_files(folder.path(), "docs/a.md"), FileNames({"chart/gone.h", "b.md"}));
}

}  // namespace
}  // namespace burin::test
