// Checks the headers that are installed for applications, which cmake/PublicHeaders.cmake lists.
#include <burin/base/file.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "all_matches.h"

namespace burin::test {
namespace {

namespace fs = std::filesystem;
using HeaderNames = std::set<std::string>;

const fs::path root = BURIN_SOURCE_FOLDER;

/// "FOLDER/FILE.h".
HeaderNames public_headers() {
  static const std::regex line(R"(\n  ([\w/]+\.h))");
  return all_matches<HeaderNames>(read_file(root / "cmake/PublicHeaders.cmake"), line);
}

HeaderNames included_by(const std::string& header) {
  static const std::regex include(R"(#include <burin/([^>]+)>)");
  return all_matches<HeaderNames>(read_file(root / "sdk/burin" / header), include);
}

/// A header and all that it includes of Burin.
void collect(const std::string& header, HeaderNames& all) {
  if (!all.insert(header).second) return;
  for (const std::string& next : included_by(header)) collect(next, all);
}

bool is_public_folder(const std::string& header) {
  return header.starts_with("abi/") || header.starts_with("math/") || header == "version.h";
}

TEST(PublicHeaders, IncludeNothingThatIsNotInstalled) {
  const HeaderNames headers = public_headers();
  EXPECT_GE(headers.size(), 40u);
  EXPECT_LE(headers.size(), 56u);
  for (const std::string& header : headers) {
    EXPECT_TRUE(fs::exists(root / "sdk/burin" / header)) << header;
    for (const std::string& included : included_by(header))
      EXPECT_TRUE(headers.contains(included) || is_public_folder(included)) << header << ": " << included;
  }
}

TEST(PublicHeaders, StandAtTheTopOfTheirFolders) {
  for (const std::string& header : public_headers())
    EXPECT_EQ(std::count(header.begin(), header.end(), '/'), 1) << header;
}

TEST(PublicHeaders, OfASessionAreFew) {
  HeaderNames headers;
  collect("host/session.h", headers);
  EXPECT_TRUE(headers.contains("base/error.h"));
  EXPECT_LE(headers.size(), 25u);
}

}  // namespace
}  // namespace burin::test
