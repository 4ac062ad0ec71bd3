#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace burin::test {

/// A line that includes a file. Paths are relative to the repository.
struct Include {
  std::filesystem::path file;
  std::size_t line;
  std::string target;         ///< as the line has it
  std::filesystem::path own;  ///< the file of the repository that it names; empty: another's
};

/// All includes below the repository's sdk/burin, brushes and host_stub.
std::vector<Include> all_includes(const std::filesystem::path& repository);

/// "FILE:LINE".
std::string at(const Include& include);

/// Whether the file is C or C++.
bool is_source(const std::filesystem::path& file);

/// The folder of the house that holds a file: the part behind sdk/burin, or the first one.
std::string house_folder(const std::filesystem::path& file);

/// The room that holds a file: "chart" at the top of that folder, "chart/front" in a folder below it.
std::string room(const std::filesystem::path& file);

}  // namespace burin::test
