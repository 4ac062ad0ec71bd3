#pragma once
#include <filesystem>
#include <string_view>
#include <vector>

namespace burin {

/// Reads one number per vertex from a PLY file: its vertex property with this name, `quality` or `red`, as it
/// is in the file. Vertices keep the file's order. Throws FileError if the file is none or has no such
/// property, is cut off, or if a number is not finite; the message lists the properties that there are. May
/// be called on any thread, also on several at once.
std::vector<float> read_vertex_scalar(const std::filesystem::path& path, std::string_view name);

}  // namespace burin
