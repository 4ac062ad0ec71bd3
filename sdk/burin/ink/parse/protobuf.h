#pragma once
#include <burin/ink/parse/byte_reader.h>

#include <cstdint>
#include <vector>

namespace burin {

/// A field of a message in the wire format of Protocol Buffers.
struct ProtobufField {
  std::uint64_t number = 0;
  int wire = 0;             ///< 0 varint, 1 eight bytes, 2 bytes with their length, 5 four bytes
  std::uint64_t value = 0;  ///< of the wires 0, 1 and 5
  ByteReader content;       ///< of the wire 2, else empty

  double as_double() const { return std::bit_cast<double>(value); }
  float as_float() const { return std::bit_cast<float>(static_cast<std::uint32_t>(value)); }
  /// Appends the signed integers of a field that has several: packed into one field, or one a field.
  void append_signed(std::vector<std::int64_t>& values) const;
};

/// Removes the next field from the front of a message that is not empty. Throws FileError.
ProtobufField next_field(ByteReader& message);

/// A signed integer whose sign is the lowest bit of a varint.
std::int64_t unzigzag(std::uint64_t value);

}  // namespace burin
