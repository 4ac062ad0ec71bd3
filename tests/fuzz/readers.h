#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace burin::fuzz {

/// A reader of files that come from anywhere.
struct Reader {
  const char* name;
  const char* extension;                            ///< with its dot
  void (*read)(const std::filesystem::path& path);  ///< as the commands do before they draw
  /// Reads it in other ways, which must agree; null where there are none.
  void (*compare)(const std::filesystem::path& path) = nullptr;
};

std::span<const Reader> readers();

/// The reader with this name, or null.
const Reader* reader_named(const std::string& name);

/// Reads a file and goes as far with it as the commands do before they draw. Returns whether the file was
/// accepted: it may be refused by an error of Burin, and nothing else.
bool accepts(const Reader& reader, const std::filesystem::path& path);

/// The same, after the file was read in all other ways. Throws std::logic_error where these differ.
bool accepts_however_read(const Reader& reader, const std::filesystem::path& path);

/// Files of a reader's format, written by the project's own writers and by hand.
std::vector<std::filesystem::path> write_seeds(const Reader& reader, const std::filesystem::path& folder);

}  // namespace burin::fuzz
