#pragma once
#include <filesystem>

namespace burin {

/// Where the stock brushes of this program are: beside it in a build, in lib when installed.
std::filesystem::path own_brush_folder();

}  // namespace burin
