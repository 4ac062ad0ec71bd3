// Makes a temporary folder with a stamp image for the checks.
#include "validate/work_folder.h"

#include <burin/stamp/files/picture.h>

#include <cstdlib>
#include <string>

namespace burin::validate {
namespace {

/// An image of soft hills that tiles.
void write_stamp(const std::filesystem::path& path) {
  Picture picture{32, 32, {}};
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      const int rise = (x < 16 ? x : 31 - x) * (y < 16 ? y : 31 - y);
      picture.rgb.insert(picture.rgb.end(), 3, static_cast<std::uint8_t>(rise));
    }
  write_png(path, picture);
}

}  // namespace

WorkFolder::WorkFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "burin-validate-XXXXXX").string();
  if (!mkdtemp(name.data())) throw FileError(name, "the folder cannot be made");
  path_ = name;
  write_stamp(stamp());
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

Subject WorkFolder::subject(const std::filesystem::path& module, std::uint64_t seed) const {
  return {std::filesystem::absolute(module), path_, stamp(), seed};
}

}  // namespace burin::validate
