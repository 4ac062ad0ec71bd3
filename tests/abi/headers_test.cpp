#include <burin/base/file.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "layout.h"

namespace burin {
namespace {

namespace fs = std::filesystem;

std::map<fs::path, std::string> header_texts() {
  std::map<fs::path, std::string> texts;
  for (const auto& entry : fs::recursive_directory_iterator(BURIN_ABI_FOLDER))
    if (entry.path().extension() == ".h") texts[entry.path()] = read_file(entry.path());
  return texts;
}

std::set<std::string> first_groups(const std::string& text, const char* pattern) {
  std::set<std::string> found;
  const std::regex regex(pattern);
  for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match)
    found.insert((*match)[1]);
  return found;
}

TEST(AbiHeaders, DefineNoStructThatTheLayoutForgets) {
  std::set<std::string> listed, defined;
  std::size_t count = 0;
  const layout_line* lines = burin_layout_in_c(&count);
  for (std::size_t i = 0; i < count; ++i) listed.insert(lines[i].type);
  for (const auto& [path, text] : header_texts())
    defined.merge(first_groups(text, R"(typedef struct (\w+) \{)"));
  EXPECT_EQ(defined, listed);
}

TEST(AbiHeaders, StandOnTwoHeadersOfTheLanguage) {
  for (const auto& [path, text] : header_texts()) {
    SCOPED_TRACE(path);
    for (const std::string& header : first_groups(text, "#include <(.*)>"))
      EXPECT_TRUE(header == "stddef.h" || header == "stdint.h") << header;
    for (const std::string& header : first_groups(text, "#include \"(.*)\""))
      EXPECT_TRUE(fs::exists(path.parent_path() / header)) << header;
  }
}

}  // namespace
}  // namespace burin
