// Reads the wire format of Protocol Buffers: fields, each a number, how it is written, and a value.
#include <burin/ink/parse/protobuf.h>

namespace burin {

std::int64_t unzigzag(std::uint64_t value) {
  return static_cast<std::int64_t>((value >> 1) ^ (~(value & 1) + 1));
}

ProtobufField next_field(ByteReader& message) {
  const std::uint64_t key = message.varint();
  ProtobufField field{.number = key >> 3,
                      .wire = static_cast<int>(key & 7),
                      .content = {{}, message.path(), message.place()}};
  switch (field.wire) {
    case 0:
      field.value = message.varint();
      break;
    case 1:
      field.value = message.take<std::uint64_t>();
      break;
    case 2:
      field.content = message.part(message.varint());
      break;
    case 5:
      field.value = message.take<std::uint32_t>();
      break;
    default:
      message.reject("no field of a message");
  }
  return field;
}

void ProtobufField::append_signed(std::vector<std::int64_t>& values) const {
  if (wire == 0) values.push_back(unzigzag(value));
  for (ByteReader packed = content; !packed.empty();) values.push_back(unzigzag(packed.varint()));
}

}  // namespace burin
