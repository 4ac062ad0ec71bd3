#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace burin::fuzz {

/// A reader of files that come from anywhere.
struct Reader {
  const char* name;
  const char* extension;  ///< with its dot
  void (*read)(const std::filesystem::path& path);
};

std::span<const Reader> readers();

/// The reader with this name, or null.
const Reader* reader_named(const std::string& name);

/// Reads a file and goes as far with it as the commands do before they draw. Returns whether the file was
/// accepted: it may be refused by an error of Burin, and nothing else.
bool accepts(const Reader& reader, const std::filesystem::path& path);

/// Files of a reader's format, written by the project's own writers and by hand.
std::vector<std::filesystem::path> write_seeds(const Reader& reader, const std::filesystem::path& folder);

}  // namespace burin::fuzz
