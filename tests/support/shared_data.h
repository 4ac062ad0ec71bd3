#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace burin::test {

/// The file of this name below ../shared/data, unpacked where the folder has it as NAME.xz; nothing where
/// the folder is absent, as it is for users. BURIN_SHARED_DATA in the environment names another folder.
std::optional<std::filesystem::path> shared_data(std::string_view name);

/// The name of a test of a mesh file: that without its extensions, with '_' for what no name of a test has.
std::string test_name_of(std::string_view file);

/// A new empty folder for files of the running test, removed when the object dies.
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
