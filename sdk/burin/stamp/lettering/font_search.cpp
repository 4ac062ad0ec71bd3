// Finds font files by name.
#include <burin/base/error.h>
#include <burin/stamp/lettering/font_search.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>

namespace burin {
namespace fs = std::filesystem;

namespace {

/// Appends the folder `below` the one that an environment variable names, if the variable is set.
void add_below(std::vector<fs::path>& folders, const char* variable, const fs::path& below) {
  if (const char* value = std::getenv(variable); value && *value) folders.push_back(value / below);
}

std::optional<fs::path> first_named(const fs::path& folder, const fs::path& name) {
  std::optional<fs::path> found;
  std::error_code error;
  fs::recursive_directory_iterator entry(
      folder, fs::directory_options::skip_permission_denied | fs::directory_options::follow_directory_symlink,
      error);
  for (const fs::recursive_directory_iterator end; !error && entry != end; entry.increment(error)) {
    std::error_code unknown;
    if (entry->path().filename() == name && entry->is_regular_file(unknown) &&
        (!found || entry->path() < *found))
      found = entry->path();
  }
  return found;
}

std::string list_of(const std::vector<fs::path>& folders) {
  std::string text;
  for (const fs::path& folder : folders) text += (text.empty() ? "" : ", ") + folder.string();
  return text;
}

}  // namespace

std::vector<fs::path> system_font_folders() {
  std::vector<fs::path> folders;
#if defined(_WIN32)
  add_below(folders, "LOCALAPPDATA", "Microsoft/Windows/Fonts");
  add_below(folders, "WINDIR", "Fonts");
#elif defined(__APPLE__)
  add_below(folders, "HOME", "Library/Fonts");
  folders.insert(folders.end(), {"/Library/Fonts", "/System/Library/Fonts"});
#else
  add_below(folders, "XDG_DATA_HOME", "fonts");
  if (folders.empty()) add_below(folders, "HOME", ".local/share/fonts");
  folders.insert(folders.end(), {"/usr/local/share/fonts", "/usr/share/fonts"});
#endif
  return folders;
}

fs::path find_font(const fs::path& font, const std::vector<fs::path>& folders) {
  std::error_code error;
  if (fs::is_regular_file(font, error)) return font;
  if (font.empty()) throw Error("no font is named");
  if (font.has_parent_path()) throw FileError(font.string(), "there is no such font file");
  for (const fs::path& folder : folders)
    if (const auto found = first_named(folder, font)) return *found;
  throw FileError(font.string(), "there is no such font, neither here nor in " + list_of(folders));
}

}  // namespace burin
