// Fills the files of a new project. A line of a file that begins with "?WORD " is there only if the project
// has that language or feature, with "?!WORD " only if it has not; the rest of the line may begin likewise.
#include "new/starter.h"

#include <burin/base/error.h>
#include <burin/base/text/quoted_word.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>
#include <string_view>
#include <utility>

#include "new/starter_texts.h"

namespace burin {
namespace {

/// Names that CMake refuses for targets, as its generators have them.
constexpr std::array<std::string_view, 11> cmake_targets = {
    "all",     "clean",          "edit_cache", "help",          "install", "list_install_components",
    "package", "package_source", "preinstall", "rebuild_cache", "test"};

constexpr std::size_t longest_name = 40;

void check_name(const std::string& name) {
  const bool begins = !name.empty() && name[0] >= 'a' && name[0] <= 'z';
  if (!begins || name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") != name.npos)
    throw Error(fmt::format("{}: a name is of a-z, 0-9 and _ and begins with a letter", quoted_word(name)));
  if (name.size() > longest_name)
    throw Error(fmt::format("{}: a name has at most {} characters", quoted_word(name), longest_name));
  if (std::ranges::find(cmake_targets, name) != cmake_targets.end())
    throw Error(fmt::format("{}: CMake has a target of this name", quoted_word(name)));
}

void check_features(const Starter& starter) {
  for (const std::string& feature : starter.features)
    if (!starter_features().contains(feature))
      throw Error(fmt::format("--features: no {}; there are: {}", quoted_word(feature),
                              fmt::join(starter_features(), ", ")));
}

/// "My brush".
std::string title_of(std::string name) {
  std::ranges::replace(name, '_', ' ');
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

/// "MyBrushPlugin": no class of the SDK has a name that ends so.
std::string class_of(const std::string& name) {
  std::string result;
  bool begins = true;
  for (const char c : name) {
    if (c != '_') result += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    begins = c == '_';
  }
  return result + "Plugin";
}

/// "org.example.my-brush".
std::string id_of(std::string name) {
  std::ranges::replace(name, '_', '-');
  return "org.example." + name;
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

/// Removes the conditions at the beginning of a line; returns whether they hold.
bool take_conditions(std::string& line, const std::set<std::string>& words) {
  bool hold = true;
  while (line.starts_with('?')) {
    const bool absent = line.starts_with("?!");
    const std::size_t begin = absent ? 2 : 1, end = std::min(line.find(' '), line.size());
    hold = hold && words.contains(line.substr(begin, end - begin)) != absent;
    line.erase(0, std::min(end + 1, line.size()));
  }
  return hold;
}

std::string filled(const char* file, const Starter& starter) {
  std::set<std::string> words = starter.features;
  words.insert(starter.language == StarterLanguage::c ? "c" : "cpp");
  std::istringstream lines(file);
  std::string text;
  for (std::string line; std::getline(lines, line);)
    if (take_conditions(line, words)) text += line + "\n";
  const std::array<std::pair<std::string_view, std::string>, 4> values = {
      {{"@NAME@", starter.name},
       {"@TITLE@", title_of(starter.name)},
       {"@CLASS@", class_of(starter.name)},
       {"@ID@", id_of(starter.name)}}};
  for (const auto& [word, value] : values) replace_all(text, word, value);
  return text;
}

}  // namespace

const std::set<std::string>& starter_features() {
  static const std::set<std::string> features = {"tile", "paint", "volume"};
  return features;
}

std::vector<StarterFile> starter_files(const Starter& starter) {
  check_name(starter.name);
  check_features(starter);
  const bool c = starter.language == StarterLanguage::c;
  return {{starter.name + (c ? ".c" : ".cpp"),
           filled(c ? starter_texts::brush_c : starter_texts::brush_cpp, starter)},
          {"CMakeLists.txt", filled(starter_texts::cmake_lists, starter)},
          {"CMakePresets.json", filled(starter_texts::cmake_presets, starter)},
          {"README.md", filled(starter_texts::readme, starter)},
          {".github/workflows/brush.yml", filled(starter_texts::workflow, starter)}};
}

}  // namespace burin
