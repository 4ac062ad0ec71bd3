#pragma once
#include <burin/surface/formats/ply_header.h>

#include <cstdint>
#include <string_view>

namespace burin {

/// Reads the numbers after the header of a PLY file in sequence.
class PlyValues {
 public:
  /// `data` must outlive the object.
  PlyValues(std::string_view data, PlyFormat format) : data_(data), format_(format) {}

  /// The next number. Throws Error if the data end, or if a word of a text file is not a number.
  double next(PlyType type);

  /// The length of a list. Throws Error as next() does, and if it is negative or above 2^32 - 1.
  std::uint64_t next_count(PlyType type);

 private:
  double next_word();

  std::string_view data_;
  PlyFormat format_;
};

}  // namespace burin
