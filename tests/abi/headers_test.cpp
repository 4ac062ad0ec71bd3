#include <burin/base/file.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
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

/// Drafts may still change.
bool is_draft(const fs::path& header) { return header.parent_path().filename() == "draft"; }

/// Every text that stands between `before` and the next `after`.
std::set<std::string> texts_between(const std::string& text, const std::string& before,
                                    const std::string& after) {
  std::set<std::string> found;
  for (std::size_t at = text.find(before); at != text.npos; at = text.find(before, at)) {
    at += before.size();
    found.insert(text.substr(at, text.find(after, at) - at));
  }
  return found;
}

TEST(AbiHeaders, DefineNoStructThatTheLayoutForgets) {
  std::set<std::string> listed, defined;
  std::size_t count = 0;
  const layout_line* lines = burin_layout_in_c(&count);
  for (std::size_t i = 0; i < count; ++i) listed.insert(lines[i].type);
  for (const auto& [path, text] : header_texts())
    if (!is_draft(path)) defined.merge(texts_between(text, "typedef struct ", " {"));
  EXPECT_EQ(defined, listed);
}

TEST(AbiHeaders, MarkDraftsInTheIdsOfExtensions) {
  std::size_t extensions = 0;
  for (const auto& [path, text] : header_texts())
    for (const std::string& id : texts_between(text, "#define BURIN_EXT_", "\"\n")) {
      ++extensions;
      EXPECT_EQ(id.find("/draft-") != id.npos, is_draft(path)) << path << ": " << id;
    }
  EXPECT_EQ(extensions, 8u);
}

TEST(AbiHeaders, StandOnTwoHeadersOfTheLanguage) {
  for (const auto& [path, text] : header_texts()) {
    SCOPED_TRACE(path);
    for (const std::string& header : texts_between(text, "#include <", ">"))
      EXPECT_TRUE(header == "stddef.h" || header == "stdint.h") << header;
    for (const std::string& header : texts_between(text, "#include \"", "\""))
      EXPECT_TRUE(fs::exists(path.parent_path() / header)) << header;
  }
}

}  // namespace
}  // namespace burin
