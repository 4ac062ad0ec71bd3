#pragma once
#include <set>
#include <string>
#include <vector>

namespace burin {

enum class StarterLanguage { c, cpp };

/// A project of its own with one brush.
struct Starter {
  std::string name;  ///< of the folder, the module and the CMake target, "my_brush"
  StarterLanguage language = StarterLanguage::cpp;
  std::set<std::string> features;  ///< names of starter_features()
};

struct StarterFile {
  std::string path;  ///< in the folder of the project
  std::string text;
};

/// What a brush may have besides a displacement: "tile", "paint" and "volume".
const std::set<std::string>& starter_features();

/// The files of the project. Throws Error if the name is not of a-z, 0-9 and _ after a letter, is longer than
/// 40 characters or a target that CMake has itself, and for a feature that the language does not have.
std::vector<StarterFile> starter_files(const Starter& starter);

}  // namespace burin
