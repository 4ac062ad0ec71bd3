#include <burin/base/file.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "support/process.h"
#include "support/shared_data.h"

namespace burin::paper {
namespace {

/// The first element that is not closed where it must be, or nothing.
std::string first_unclosed(const std::string& page) {
  static const std::regex tag("<(/?)([a-z][a-z0-9]*)[^>]*?(/?)>");
  std::vector<std::string> open;
  for (std::sregex_iterator match(page.begin(), page.end(), tag), end; match != end; ++match) {
    const std::string name = (*match)[2];
    if ((*match)[1].length() > 0) {
      if (open.empty() || open.back() != name) return "/" + name;
      open.pop_back();
    } else if ((*match)[3].length() == 0) {
      open.push_back(name);
    }
  }
  return open.empty() ? "" : open.back();
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// The page without the bytes of its pictures.
std::string without_pictures(std::string page) {
  const std::string begin = "base64,";
  for (auto at = page.find(begin); at != std::string::npos; at = page.find(begin, at + 1))
    page.erase(at + begin.size(), page.find('"', at) - at - begin.size());
  return page;
}

TEST(PaperBench, WritesOnePageThatNeedsNothingElse) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "paper.html";
  const auto run = test::run_process({BURIN_PAPER_BENCH, "--quick", "--out", file.string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string whole = read_file(file), page = without_pictures(whole);
  EXPECT_GE(count(whole, "src=\"data:image/png;base64,iVBOR"), 9U);
  EXPECT_EQ(count(page, "<svg"), 2U);
  EXPECT_EQ(count(page, "nan"), 0U) << "in a table or a plot";
  EXPECT_EQ(count(page, "http"), 0U);
  for (const char* figure : {"10", "11", "12", "13", "14"})
    EXPECT_EQ(count(page, std::string("<h2>Figure ") + figure), 1U);
  EXPECT_EQ(first_unclosed(page), "");
}

}  // namespace
}  // namespace burin::paper
