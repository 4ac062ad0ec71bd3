#pragma once
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace burin {

/// Most bytes of XML and of JSON, and what any packed file may unpack to.
constexpr std::size_t most_parsed_bytes = 60'000'000;

/// Most bytes that so many bytes of a packed file may unpack to. Handwriting has a fourth of its size or more
/// when packed; what unpacks to many times its size was made to exhaust the memory.
constexpr std::size_t most_unpacked_bytes(std::size_t packed_bytes) {
  constexpr std::size_t times_packed = 16, ever = std::size_t{1} << 28;
  return std::max(most_parsed_bytes, std::min(ever, times_packed * packed_bytes));
}

/// The member of a sketch of Tilt Brush that has the strokes.
constexpr std::string_view sketch_member = "data.sketch";

/// Whether bytes begin as a gzip, xz or zip file does.
bool is_packed(std::string_view bytes);

/// The bytes of a file, or of the sketch that a folder holds; unpacked if they are gzip or xz, and
/// content.xml or the first .will or .protobuf if they are a zip that has one. Throws FileError for a damaged
/// archive, where more than most_unpacked_bytes() come out, and for more than most_parsed_bytes of a text
/// that begins as XML or JSON, before it is read.
std::string unpacked_pen_file(const std::filesystem::path& path);

/// The member of a zip with this name. Throws FileError as above, and if there is none.
std::string zip_member(const std::filesystem::path& path, std::string_view bytes, std::string_view name);

}  // namespace burin
