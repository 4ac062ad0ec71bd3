#pragma once
#include <burin/ink/parse/byte_reader.h>

#include <compare>
#include <cstdint>

namespace burin {

/// Names an item of a page: who made it, and a count.
struct RemarkableId {
  std::uint8_t author = 0;
  std::uint64_t number = 0;
  auto operator<=>(const RemarkableId&) const = default;
};

/// A value of reMarkable's version 6 with the tag before it: its index, and how it is written. Only what its
/// kind has is set.
struct RemarkableValue {
  std::uint64_t index = 0;
  RemarkableId id;
  std::uint64_t number = 0;  ///< the bits, whatever they mean
  ByteReader content;        ///< of a part
};

RemarkableId take_remarkable_id(ByteReader& bytes);

/// Removes the next value. Throws FileError if there is none.
RemarkableValue take_remarkable_value(ByteReader& bytes);

/// The value in a part that also tells who set it last. Throws FileError if there is none.
RemarkableValue last_set_value(ByteReader part);

/// A value of four bytes as a real number.
float real_of(const RemarkableValue& value);

}  // namespace burin
