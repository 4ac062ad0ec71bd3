#pragma once
#include <burin/surface/formats/ply_header.h>

#include <cstdint>
#include <string_view>

namespace burin {

/// The numbers behind the header of a PLY file, one after the other.
class PlyValues {
 public:
  /// `data` must outlive this.
  PlyValues(std::string_view data, PlyFormat format) : data_(data), format_(format) {}

  /// Throws Error when the file is cut off or holds something else.
  double next(PlyType type);

  /// The same for the length of a list.
  std::uint64_t next_count(PlyType type);

 private:
  double next_word();

  std::string_view data_;
  PlyFormat format_;
};

}  // namespace burin
