#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace burin::test {

/// The file with this name below ../shared/data, unpacked if the folder has it as NAME.xz; nothing if the
/// folder is absent, as it is for users. The environment variable BURIN_SHARED_DATA sets another folder.
std::optional<std::filesystem::path> shared_data(std::string_view name);

/// A test name for a mesh file: the file name without extensions, with '_' for characters that test names
/// cannot have.
std::string test_name_of(std::string_view file);

/// A new empty folder for files of the running test; the destructor removes it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace burin::test

/// Defines `variable` as the path of the file, or skips the test with a message.
#define BURIN_SHARED_DATA_OR_SKIP(variable, name)                                                  \
  const auto variable##_found = ::burin::test::shared_data(name);                                  \
  if (!variable##_found) GTEST_SKIP() << "../shared/data/" << (name) << " is not on this machine"; \
  const std::filesystem::path& variable = *variable##_found  // NOLINT(bugprone-macro-parentheses)
