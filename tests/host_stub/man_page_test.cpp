#include <gtest/gtest.h>

#include <sstream>

#include "run_command.h"

namespace burin::test {
namespace {

/// The subcommands that the help lists.
std::vector<std::string> subcommands() {
  const std::string help = burin_output({"--help"});
  std::istringstream lines(help.substr(help.find("Subcommands:\n")));
  std::vector<std::string> names;
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line))
    if (line.starts_with("  ") && line[2] != ' ') names.push_back(line.substr(2, line.find(' ', 2) - 2));
  return names;
}

TEST(ManPage, DescribesAllCommandsButItself) {
  const std::string page = burin_output({"man-page"});
  const auto names = subcommands();
  EXPECT_GT(names.size(), 10u);
  for (const std::string& name : names)
    EXPECT_NE(page.find(".SS burin " + (name == "bench-brush" ? "bench\\-brush" : name) + " "),
              std::string::npos)
        << name;
  EXPECT_EQ(page.find("man\\-page"), std::string::npos);
  EXPECT_NE(page.find("\\fB\\-\\-fuzz\\fR \\fIMINUTES\\fR"), std::string::npos);
}

TEST(ManPage, NamesNoFoldersOfTheSources) {
  const std::string page = burin_output({"man-page"});
  for (const char* folder : {"docs/", "samples/", "build/release"})
    EXPECT_EQ(page.find(folder), std::string::npos) << folder;
}

TEST(ManPage, HasNothingThatManComplainsAbout) {
  const CommandFolder folder;
  const std::string page = folder.write("burin.1", burin_output({"man-page"}));
  const ProcessResult checked =
      run_process({"sh", "-c", "command -v groff >/dev/null || exit 9; exec groff -man -ww -z -Tutf8 \"$1\"",
                   "sh", page});
  if (checked.exit_code == 9) GTEST_SKIP() << "no groff here";
  EXPECT_EQ(checked.err, "");
}

}  // namespace
}  // namespace burin::test
