#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace burin {

/// Most bytes of XML and of JSON, and most that a packed file may unpack to.
constexpr std::size_t most_parsed_bytes = 60'000'000;

/// The member of a sketch of Tilt Brush that has the strokes.
constexpr std::string_view sketch_member = "data.sketch";

/// The bytes of a file, or of the sketch that a folder holds; unpacked if they are gzip or xz, and
/// content.xml or the first .will or .protobuf if they are a zip that has one. Throws FileError for a damaged
/// archive, and where more than most_parsed_bytes come out or are there of a text that begins as XML or JSON,
/// before it is read.
std::string unpacked_pen_file(const std::filesystem::path& path);

/// The member of a zip with this name. Throws FileError as above, and if there is none.
std::string zip_member(const std::filesystem::path& path, std::string_view bytes, std::string_view name);

}  // namespace burin
