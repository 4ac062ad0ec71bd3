#pragma once
#include <filesystem>
#include <fstream>
#include <string>

namespace burin::test {

/// Writes a file of a repository that a test makes up.
inline void plant(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

}  // namespace burin::test
