#include "support/shared_data.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace burin::test {
namespace fs = std::filesystem;

namespace {

fs::path data_folder() {
  const char* other = std::getenv("BURIN_SHARED_DATA");
  return other ? other : BURIN_SHARED_DATA;
}

/// Unpacks to a private name first, since tests of several processes may need the same file at once.
fs::path unpacked(const fs::path& packed, const fs::path& name) {
  const fs::path file = fs::path(BURIN_TEST_CACHE) / name;
  if (fs::exists(file)) return file;
  fs::create_directories(file.parent_path());
  const fs::path partial = file.string() + "." + std::to_string(getpid());
  const std::string command =
      std::string(BURIN_XZ) + " -dc '" + packed.string() + "' > '" + partial.string() + "'";
  if (std::system(command.c_str()) != 0) throw std::runtime_error("cannot unpack " + packed.string());
  fs::rename(partial, file);
  return file;
}

}  // namespace

std::string test_name_of(std::string_view file) {
  std::string name(file.substr(0, file.find('.')));
  std::ranges::replace_if(
      name, [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}

std::optional<fs::path> shared_data(std::string_view name) {
  const fs::path file = data_folder() / name;
  if (fs::exists(file)) return file;
  const fs::path packed = file.string() + ".xz";
  if (fs::exists(packed)) return unpacked(packed, name);
  if (fs::exists(data_folder())) throw std::runtime_error("no " + file.string());
  return std::nullopt;
}

TemporaryFolder::TemporaryFolder() {
  static std::atomic<int> count{0};
  path_ =
      fs::temp_directory_path() / ("burin-test-" + std::to_string(getpid()) + "-" + std::to_string(count++));
  fs::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace burin::test
