#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

enum class PlyFormat { ascii, little_endian, big_endian };

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count_type;  ///< present for a list: the type of its length
};

struct PlyElement {
  std::string name;
  std::uint64_t count;
  std::vector<PlyProperty> properties;
};

/// What a PLY file says of itself [Turk 1994], elements in the order of their data.
struct PlyHeader {
  PlyFormat format;
  std::vector<PlyElement> elements;
  std::size_t size = 0;  ///< bytes of the header; the data follow
};

/// Reads the header that a file begins with. Throws FileError naming the line.
PlyHeader read_ply_header(std::string_view text, const std::filesystem::path& path);

/// The property of this name, or nothing.
const PlyProperty* find_property(const PlyElement& element, std::string_view name);

}  // namespace burin
