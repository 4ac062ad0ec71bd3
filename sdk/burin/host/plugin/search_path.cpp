// Finds plugins by their file names. A library with another name is searched for the plugin's symbol as
// bytes, since loading it would run its code.
#include <burin/abi/plugin.h>
#include <burin/base/error.h>
#include <burin/base/file.h>
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

template <class Wanted>
std::vector<fs::path> files_of(const fs::path& folder, const Wanted& wanted) {
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    if (wanted(at->path())) files.push_back(at->path());
  if (error) throw FileError(folder.string(), "plugins cannot be listed: " + error.message());
  std::sort(files.begin(), files.end());
  return files;
}

/// Whether the table of names in a shared library has the symbol of a plugin.
bool exports_plugin(const fs::path& library) {
  const std::string symbol = std::string(1, '\0') + BURIN_PLUGIN_SYMBOL + '\0';
  constexpr std::uintmax_t most = 16 << 20;
  std::error_code error;
  if (!fs::is_regular_file(library, error) || fs::file_size(library, error) > most) return false;
  try {
    return read_file(library).find(symbol) != std::string::npos;
  } catch (const Error&) {
    return false;
  }
}

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
  return files_of(folder, [](const fs::path& file) { return file.extension() == ".burin"; });
}

std::vector<fs::path> misnamed_plugins(const fs::path& folder) {
  return files_of(folder, [](const fs::path& file) {
    const fs::path ending = file.extension();
    return (ending == ".so" || ending == ".dll" || ending == ".dylib") && exports_plugin(file);
  });
}

}  // namespace burin
