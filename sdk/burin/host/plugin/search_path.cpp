#include <burin/base/error.h>
#include <burin/host/plugin/search_path.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <system_error>

namespace burin {
namespace fs = std::filesystem;

namespace {

#if defined(_WIN32)
constexpr char separator = ';';
#else
constexpr char separator = ':';
#endif

}  // namespace

std::vector<fs::path> plugin_search_path() {
  std::vector<fs::path> folders;
  const char* variable = std::getenv("BURIN_PLUGIN_PATH");
  for (std::string_view rest = variable ? variable : ""; !rest.empty();) {
    const std::string_view folder = rest.substr(0, rest.find(separator));
    if (!folder.empty()) folders.emplace_back(folder);
    rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
  }
  return folders;
}

std::vector<fs::path> plugin_files(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    if (at->path().extension() == ".burin") files.push_back(at->path());
  if (error) throw FileError(folder.string(), "plugins cannot be listed: " + error.message());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace burin
