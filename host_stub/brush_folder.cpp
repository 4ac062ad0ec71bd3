#include "brush_folder.h"

#include "platform.h"

namespace burin {

std::filesystem::path own_brush_folder() {
  const std::filesystem::path beside = executable_folder() / "brushes";
  if (std::filesystem::is_directory(beside)) return beside;
  return executable_folder().parent_path() / "lib" / "burin" / "brushes";
}

}  // namespace burin
