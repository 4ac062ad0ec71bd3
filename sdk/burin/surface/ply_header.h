#pragma once
#include <cstdint>
#include <filesystem>
#include <istream>
#include <optional>
#include <string>
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
};

/// Reads up to the first byte of data. Throws FileError naming the line.
PlyHeader read_ply_header(std::istream& in, const std::filesystem::path& path);

}  // namespace burin
