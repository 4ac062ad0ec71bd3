// Takes the tagged values of reMarkable's version 6 one by one.
#include <burin/ink/parse/remarkable_tagged.h>

#include <bit>

namespace burin {
namespace {

enum Written : std::uint8_t { one_byte = 1, four_bytes = 4, eight_bytes = 8, part = 12, id = 15 };

}  // namespace

RemarkableId take_remarkable_id(ByteReader& bytes) {
  const auto author = bytes.take<std::uint8_t>();
  return {author, bytes.varint()};
}

RemarkableValue take_remarkable_value(ByteReader& bytes) {
  const std::uint64_t tag = bytes.varint();
  RemarkableValue value{.index = tag >> 4, .id = {}, .content = {{}, bytes.path(), bytes.place()}};
  switch (tag & 0xF) {
    case Written::one_byte:
      value.number = bytes.take<std::uint8_t>();
      break;
    case Written::four_bytes:
      value.number = bytes.take<std::uint32_t>();
      break;
    case Written::eight_bytes:
      value.number = bytes.take<std::uint64_t>();
      break;
    case Written::part:
      value.content = bytes.part(bytes.take<std::uint32_t>());
      break;
    case Written::id:
      value.id = take_remarkable_id(bytes);
      break;
    default:
      bytes.reject("no tagged value");
  }
  return value;
}

RemarkableValue last_set_value(ByteReader part) {
  constexpr std::uint64_t value_index = 2;
  while (!part.empty()) {
    RemarkableValue value = take_remarkable_value(part);
    if (value.index == value_index) return value;
  }
  part.reject("a part without its value");
}

float real_of(const RemarkableValue& value) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(value.number));
}

}  // namespace burin
