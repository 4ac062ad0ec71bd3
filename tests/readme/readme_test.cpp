#include <burin/base/file.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>

#include "markdown.h"
#include "sanitizers/sanitized.h"
#include "support/shared_data.h"

namespace burin::test {
namespace {

namespace fs = std::filesystem;

const fs::path source_folder = BURIN_SOURCE_FOLDER;

std::string readme() { return read_file(source_folder / "README.md"); }

/// A page of the documents.
std::string page_text(const std::string& name) { return read_file(source_folder / "docs" / (name + ".md")); }

bool has_program(const std::string& name) {
  return std::system(("command -v " + name + " > /dev/null").c_str()) == 0;
}

/// A folder that looks like the root of a built checkout, to run commands in.
class Checkout {
 public:
  Checkout() {
    fs::create_directory(folder_.path() / "build");
    fs::create_directory_symlink(BURIN_BUILD_FOLDER, folder_.path() / "build/release");
    fs::create_directory_symlink(source_folder / "samples", folder_.path() / "samples");
  }

  /// Exit status of a script that stops at its first failure.
  int run(const std::string& script) const {
    write_file_whole(folder_.path() / "script", [&](std::ostream& out) { out << "set -e\n" << script; });
    return std::system(fmt::format("cd '{}' && bash script </dev/null", folder_.path().string()).c_str());
  }

  const fs::path& path() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

/// The commands with surfaces and pictures that are small enough for a test.
std::string at_test_size(const std::string& script) {
  static const std::regex size("--(target-triangles|subdivide) [0-9]+"),
      picture("burin (replay|chart|render) ");
  return std::regex_replace(std::regex_replace(script, size, "--subdivide 3"), picture,
                            "burin $1 --width 200 --height 150 ");
}

/// Files and folders that a script's options name as outputs.
std::vector<std::string> outputs_of(const std::string& script) {
  static const std::regex output(R"(--(?:report|png|csv|save-mesh|out) ([^\s]+))");
  std::vector<std::string> outputs;
  for (std::sregex_iterator match(script.begin(), script.end(), output), end; match != end; ++match)
    outputs.push_back((*match)[1]);
  return outputs;
}

TEST(Readme, RunsAsItSays) {
  const Checkout checkout;
  std::size_t scripts = 0, outputs = 0;
  for (const std::string& block : fenced_blocks(readme(), "sh")) {
    if (block.starts_with("./dev")) continue;
    SCOPED_TRACE(block);
    ASSERT_EQ(checkout.run(at_test_size(block)), 0);
    ++scripts;
    for (const std::string& output : outputs_of(block)) {
      EXPECT_TRUE(fs::exists(checkout.path() / output)) << output;
      ++outputs;
    }
  }
  EXPECT_GE(scripts, 2u);
  EXPECT_GE(outputs, 4u);
}

TEST(Readme, NamesCommandsOfDev) {
  const Checkout checkout;
  ASSERT_EQ(checkout.run(fmt::format("'{}/dev' help > help", source_folder.string())), 0);
  const std::string help = read_file(checkout.path() / "help");
  std::size_t commands = 0;
  for (const std::string& block : fenced_blocks(readme(), "sh")) {
    if (!block.starts_with("./dev")) continue;
    for (const std::string& line : lines_of(block)) {
      ASSERT_TRUE(line.starts_with("./dev ")) << line << " stands where tests do not run it";
      const std::string word = line.substr(6, line.find(' ', 6) - 6);
      EXPECT_NE(help.find(fmt::format("\n  {} ", word)), std::string::npos) << line;
      ++commands;
    }
  }
  EXPECT_GE(commands, 2u);
}

TEST(Readme, ShowsTheSampleBrush) {
  const auto blocks = fenced_blocks(readme(), "cpp");
  ASSERT_EQ(blocks.size(), 1u);
  EXPECT_EQ(blocks.front(), read_file(source_folder / "samples/hello_brush/hello_brush.cpp"));
}

/// The guide's pages that go on in the project of the first brush, in the order in which they are run.
constexpr std::array guide_pages = {"first_brush", "parameters", "debugging", "shipping"};

TEST(Guide, RunsAsItSaysWithWhatIsInstalled) {
  const Checkout checkout;
  const fs::path prefix = checkout.path() / "prefix", project = checkout.path() / "wavy_line";
  std::string script =
      fmt::format("export PATH='{0}/bin':\"$PATH\" CMAKE_PREFIX_PATH='{0}'\n", prefix.string());
  for (const char* component : {"command", "brushes", "plugin"})
    script += fmt::format("cmake --install build/release --component {} --prefix '{}' > installed\n",
                          component, prefix.string());
  for (const char* page : guide_pages)
    for (const std::string& block : fenced_blocks(page_text(page), "sh"))
      if (!block.starts_with("gdb ") || has_program("gdb")) script += block;
  ASSERT_EQ(checkout.run(std::regex_replace(script, std::regex("/usr/share"), prefix.string() + "/share")),
            0);
  for (const char* picture : {"wavy_line.png", "ewer.png", "rising.png", "sanitized.png"})
    EXPECT_TRUE(fs::exists(project / picture)) << picture;
  EXPECT_TRUE(fs::exists(project / "installed/lib/burin/brushes/wavy_line.burin"));
}

/// Pages whose commands need nothing but a build.
constexpr std::array other_pages = {"validate", "watch", "probe"};

TEST(Guide, RunsAsItSaysWithWhatIsBuilt) {
  const Checkout checkout;
  for (const char* page : other_pages) {
    const auto blocks = fenced_blocks(page_text(page), "sh");
    EXPECT_FALSE(blocks.empty()) << page;
    for (const std::string& block : blocks) EXPECT_EQ(checkout.run(at_test_size(block)), 0) << block;
  }
  EXPECT_TRUE(fs::exists(checkout.path() / "probe.txt"));
}

TEST(Guide, ShowsBrushesThatKeepToTheAbi) {
  const Checkout checkout;
  std::string lists =
      "cmake_minimum_required(VERSION 3.25)\nproject(recipes LANGUAGES C CXX)\n"
      "find_package(Burin REQUIRED COMPONENTS plugin)\n";
  std::map<std::string, int> recipes;  // by language
  for (const char* language : {"cpp", "c"})
    for (const char* page : {"brush_recipes", "parameters", "debugging", "watch"})
      for (const std::string& block : fenced_blocks(page_text(page), language)) {
        const std::string name = fmt::format("{}_{}", language, ++recipes[language]);
        write_file_whole(checkout.path() / fmt::format("{}.{}", name, language),
                         [&](std::ostream& out) { out << block; });
        lists += fmt::format("burin_add_brush({0} {0}.{1} VALIDATE 4)\n", name, language);
      }
  EXPECT_EQ(recipes, (std::map<std::string, int>{{"c", 1}, {"cpp", 11}}));
  write_file_whole(checkout.path() / "CMakeLists.txt", [&](std::ostream& out) { out << lists; });
  EXPECT_EQ(
      checkout.run("cmake --install build/release --component plugin --prefix prefix\n"
                   "cmake -G Ninja -B recipes -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH=\"$PWD/prefix\" "
                   "-DCMAKE_CXX_FLAGS='-Wall -Wextra -Wpedantic -Werror' "
                   "-DCMAKE_C_FLAGS='-Wall -Wextra -Wpedantic -Werror' "
                   "-DBURIN_PROGRAM=\"$PWD/build/release/bin/burin\"\ncmake --build recipes\n"),
      0);
}

TEST(Guide, NamesTheHelpersForC) {
  const std::string page = page_text("brush_recipes");
  for (const char* header : {"stroke_shape", "compositing"}) {
    const std::string text = read_file(source_folder / fmt::format("sdk/burin/plugin/c/{}.h", header));
    const std::regex function("static inline [^;{]*?(burin_[a-z_]+)\\(");
    int found = 0;
    for (std::sregex_iterator at(text.begin(), text.end(), function), end; at != end; ++at, ++found)
      EXPECT_NE(page.find(fmt::format("`{}(", (*at)[1].str())), std::string::npos) << (*at)[1];
    EXPECT_GT(found, 0) << header;
  }
}

TEST(EmbeddingPage, ShowsTheSampleApplication) {
  const std::string page = read_file(source_folder / "docs/embedding.md");
  const auto programs = fenced_blocks(page, "cpp"), builds = fenced_blocks(page, "cmake");
  ASSERT_GE(programs.size(), 1u);
  EXPECT_EQ(programs.front(), read_file(source_folder / "samples/embed/embed.cpp"));
  ASSERT_EQ(builds.size(), 1u);
  EXPECT_EQ(builds.front(), read_file(source_folder / "samples/embed/CMakeLists.txt"));
}

TEST(CHostsPage, RunsAsItSays) {
  if (test::sanitized) GTEST_SKIP() << "programs without sanitizers cannot load a library with them";
  const Checkout checkout;
  const auto scripts = fenced_blocks(page_text("c_hosts"), "sh");
  ASSERT_EQ(scripts.size(), 1u);
  // The program's hash is a line by itself, that of the command stands in its summary.
  ASSERT_EQ(checkout.run("(\n" + scripts.front() +
                         ") > printed\n"
                         "hash=$(grep -x '[0-9a-f]\\{16\\}' printed)\n"
                         "grep -q \"result hash  *$hash\" printed\n"),
            0);
}

TEST(Readme, LinksToFilesThatAreThere) {
  std::size_t pictures = 0;
  for (const std::string& target : link_targets(readme())) {
    EXPECT_TRUE(fs::exists(source_folder / target)) << target;
    if (!target.ends_with(".png")) continue;
    EXPECT_LT(fs::file_size(source_folder / target), 400'000u) << target;
    ++pictures;
  }
  EXPECT_GE(pictures, 1u);
}

using Arrows = std::set<std::pair<std::string, std::string>>;

/// The arrows between SDK folders in the README's diagram, from the included to the including.
Arrows drawn_arrows(const std::string& diagram) {
  static const std::regex arrow(R"((\w+) --> (?=(\w+)))");
  Arrows arrows;
  for (std::sregex_iterator match(diagram.begin(), diagram.end(), arrow), end; match != end; ++match)
    if (fs::exists(source_folder / "sdk/burin" / (*match)[2].str())) arrows.emplace((*match)[1], (*match)[2]);
  return arrows;
}

Arrows linked_targets() {
  static const std::regex target(R"(burin::(\w+))");
  Arrows arrows;
  for (const auto& entry : fs::directory_iterator(source_folder / "sdk/burin")) {
    if (!entry.is_directory()) continue;
    const std::string text = read_file(entry.path() / "CMakeLists.txt"), folder = entry.path().filename();
    for (std::sregex_iterator match(text.begin(), text.end(), target), end; match != end; ++match)
      if ((*match)[1] != folder) arrows.emplace((*match)[1], folder);
  }
  return arrows;
}

TEST(Readme, DrawsTheHouseAsItIsLinked) {
  const auto diagrams = fenced_blocks(readme(), "mermaid");
  ASSERT_EQ(diagrams.size(), 1u);
  EXPECT_EQ(drawn_arrows(diagrams.front()), linked_targets());
}

}  // namespace
}  // namespace burin::test
