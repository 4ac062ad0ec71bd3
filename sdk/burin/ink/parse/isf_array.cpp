// Unpacks the arrays of the Ink Serialized Format. The first byte tells how: by a prefix of ones that selects
// the number of bits from a table, where values are second differences; or by a fixed number of bits.
#include <burin/ink/parse/isf_array.h>

#include <array>

namespace burin {
namespace {

/// Bits from the most significant one of each byte on.
class BitReader {
 public:
  explicit BitReader(ByteReader& bytes) : bytes_(&bytes) {}

  std::uint64_t take(unsigned bits) {
    std::uint64_t value = 0;
    for (unsigned i = 0; i < bits; ++i) value = value << 1 | take_bit();
    return value;
  }

 private:
  unsigned take_bit() {
    constexpr unsigned bits_in_byte = 8;
    if (left_ == 0) {
      byte_ = bytes_->take<std::uint8_t>();
      left_ = bits_in_byte;
    }
    return byte_ >> --left_ & 1U;
  }

  ByteReader* bytes_;
  unsigned byte_ = 0, left_ = 0;
};

std::int64_t signed_of(std::uint64_t value) {
  const auto size = static_cast<std::int64_t>(value >> 1);
  return value & 1 ? -size : size;
}

/// Sums second differences. Wraps around where damaged files overflow.
class SecondSum {
 public:
  SecondSum() = default;
  SecondSum(std::int64_t first, std::int64_t second)
      : value_(static_cast<std::uint64_t>(second)), step_(value_ - static_cast<std::uint64_t>(first)) {}

  std::int64_t next(std::int64_t difference) {
    step_ += static_cast<std::uint64_t>(difference);
    value_ += step_;
    return static_cast<std::int64_t>(value_);
  }

 private:
  std::uint64_t value_ = 0, step_ = 0;
};

constexpr std::size_t longest_table = 10;

/// Bits behind a prefix of as many ones as the place in the table.
constexpr std::array<std::array<unsigned, longest_table>, 8> bits_of_tables = {{
    {0, 1, 2, 4, 6, 8, 12, 16, 24, 32},
    {0, 1, 1, 2, 4, 8, 12, 16, 24, 32},
    {0, 1, 1, 1, 2, 4, 8, 14, 22, 32},
    {0, 2, 2, 3, 5, 8, 12, 16, 24, 32},
    {0, 3, 4, 5, 8, 12, 16, 24, 32},
    {0, 4, 6, 8, 12, 16, 24, 32},
    {0, 6, 8, 12, 16, 24, 32},
    {0, 7, 8, 12, 16, 24, 32},
}};

/// The next value by a table.
std::int64_t take_prefixed(BitReader& bits, const std::array<unsigned, longest_table>& table,
                           const ByteReader& bytes) {
  std::size_t ones = 0;
  std::int64_t least = 0;  // of the sizes behind this prefix; those of shorter ones lie below
  while (bits.take(1) == 1) {
    least += ones == 0 ? 1 : std::int64_t{1} << (table[ones] - 1);
    ++ones;
    if (ones == longest_table || table[ones] == 0) bytes.reject("a number of more than 32 bits");
  }
  if (ones == 0) return 0;
  const std::uint64_t value = bits.take(table[ones]);
  const std::int64_t size = static_cast<std::int64_t>(value >> 1) + least;
  return value & 1 ? -size : size;
}

std::vector<std::int64_t> take_by_table(ByteReader& bytes, std::size_t table, std::size_t count) {
  std::vector<std::int64_t> values;
  BitReader bits(bytes);
  SecondSum sum;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(sum.next(take_prefixed(bits, bits_of_tables[table], bytes)));
  return values;
}

std::vector<std::int64_t> take_fixed(ByteReader& bytes, unsigned bits_told, bool differences,
                                     std::size_t count) {
  constexpr unsigned whole = 32;
  const unsigned width = bits_told == 0 ? whole : bits_told;
  std::vector<std::int64_t> values;
  SecondSum sum;
  if (differences && count >= 2) {
    const std::int64_t first = take_isf_signed(bytes), second = take_isf_signed(bytes);
    values = {first, second};
    sum = {first, second};
  }
  BitReader bits(bytes);
  while (values.size() < count) {
    const std::uint64_t value = bits.take(width), sign = std::uint64_t{1} << (width - 1);
    const auto number = static_cast<std::int64_t>(value ^ sign) - static_cast<std::int64_t>(sign);
    values.push_back(differences ? sum.next(number) : number);
  }
  return values;
}

}  // namespace

std::int64_t take_isf_signed(ByteReader& bytes) { return signed_of(bytes.varint()); }

std::vector<std::int64_t> take_isf_array(ByteReader& bytes, std::size_t count) {
  constexpr std::uint8_t by_table = 0x80, last_table = 0x87, fixed_end = 0x40, differences = 0x20,
                         width = 0x1F;
  if (count == 0) return {};
  const auto how = bytes.take<std::uint8_t>();
  if (how >= by_table && how <= last_table) return take_by_table(bytes, how - by_table, count);
  if (how >= fixed_end) bytes.reject("an array that is packed in no known way");
  return take_fixed(bytes, how & width, how & differences, count);
}

}  // namespace burin
