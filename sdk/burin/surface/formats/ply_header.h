#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

enum class PlyFormat { ascii, little_endian, big_endian };

/// Those of [Turk 1994] and the whole numbers of 64 bits that some programs of today write.
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

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

/// The header of a PLY file [Turk 1994]; elements are in the order of their data.
struct PlyHeader {
  PlyFormat format;
  std::vector<PlyElement> elements;
  std::size_t size = 0;  ///< size of the header, bytes; the data follow
};

/// Reads the header at the start of a file. Throws FileError, which gives the line.
PlyHeader read_ply_header(std::string_view text, const std::filesystem::path& path);

/// The property with this name, or null.
const PlyProperty* find_property(const PlyElement& element, std::string_view name);

}  // namespace burin
