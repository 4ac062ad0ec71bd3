// Reads the numbers of a PLY file, as text or as bytes in either order. The result does not depend on the
// processor's byte order.
#include <burin/base/error.h>
#include <burin/base/text/quoted_word.h>
#include <burin/surface/files/text_lines.h>
#include <burin/surface/formats/ply_values.h>
#include <fmt/format.h>

#include <bit>

namespace burin {
namespace {

std::size_t size_of(PlyType type) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

double value_of(PlyType type, std::uint64_t bits) {
  switch (type) {
    case PlyType::int8:
      return static_cast<std::int8_t>(bits);
    case PlyType::uint8:
      return static_cast<std::uint8_t>(bits);
    case PlyType::int16:
      return static_cast<std::int16_t>(bits);
    case PlyType::uint16:
      return static_cast<std::uint16_t>(bits);
    case PlyType::int32:
      return static_cast<std::int32_t>(bits);
    case PlyType::uint32:
      return static_cast<std::uint32_t>(bits);
    case PlyType::int64:
      return static_cast<double>(static_cast<std::int64_t>(bits));
    case PlyType::uint64:
      return static_cast<double>(bits);
    case PlyType::float32:
      return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    case PlyType::float64:
      return std::bit_cast<double>(bits);
  }
  return 0;
}

[[noreturn]] void fail_cut_off() { throw Error("the file is cut off"); }

}  // namespace

double PlyValues::next(PlyType type) {
  if (format_ == PlyFormat::ascii) return next_word();
  const std::size_t size = size_of(type);
  if (data_.size() < size) fail_cut_off();
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i)
    bits = bits << 8 | static_cast<unsigned char>(data_[format_ == PlyFormat::big_endian ? i : size - 1 - i]);
  data_.remove_prefix(size);
  return value_of(type, bits);
}

std::uint64_t PlyValues::next_count(PlyType type) {
  const double count = next(type);
  if (!(count >= 0 && count < 4294967296.0)) throw Error(fmt::format("has a list of {} entries", count));
  return static_cast<std::uint64_t>(count);
}

double PlyValues::next_word() {
  constexpr std::string_view blanks = " \t\v\f\r\n";
  data_.remove_prefix(std::min(data_.find_first_not_of(blanks), data_.size()));
  if (data_.empty()) fail_cut_off();
  const std::string_view word = data_.substr(0, data_.find_first_of(blanks));
  data_.remove_prefix(word.size());
  const auto value = real_number(word);
  if (!value) throw Error(fmt::format("{} is not a number", quoted_word(word)));
  return *value;
}

}  // namespace burin
