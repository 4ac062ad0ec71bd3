#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace burin::test {

/// All includes below the repository's sdk/burin, brushes and host_stub that break the house, each as
/// "FILE:LINE: WHAT".
std::vector<std::string> wrong_includes(const std::filesystem::path& repository);

/// The number of include lines that wrong_includes() checks.
std::size_t count_includes(const std::filesystem::path& repository);

}  // namespace burin::test
