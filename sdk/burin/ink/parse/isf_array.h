#pragma once
#include <burin/ink/parse/byte_reader.h>

#include <cstdint>
#include <vector>

namespace burin {

/// Removes a packed array of `count` numbers from the front of the bytes of an Ink Serialized Format stream.
/// Throws FileError where they are too few.
std::vector<std::int64_t> take_isf_array(ByteReader& bytes, std::size_t count);

/// An integer whose sign is its lowest bit and whose other bits are its size.
std::int64_t take_isf_signed(ByteReader& bytes);

}  // namespace burin
