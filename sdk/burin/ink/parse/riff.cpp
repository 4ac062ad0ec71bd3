// Reads RIFF: chunks with a name and a length, each padded to an even number of bytes.
#include <burin/ink/parse/riff.h>

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace burin {
namespace {

constexpr std::size_t form_at = 8, head_size = 12;

}  // namespace

bool is_riff(std::string_view bytes, std::string_view form) {
  return bytes.starts_with("RIFF") && bytes.size() >= head_size && bytes.substr(form_at, 4) == form;
}

RiffChunks::RiffChunks(std::string_view bytes, const std::filesystem::path& path) : rest_(bytes, path) {
  rest_.take_bytes(head_size);
}

RiffChunk RiffChunks::next() {
  const std::string_view name = rest_.take_bytes(4);
  const auto length = rest_.take<std::uint32_t>();
  RiffChunk chunk{name, rest_.part(length)};
  if (length % 2 != 0 && !rest_.empty()) rest_.take_bytes(1);
  return chunk;
}

}  // namespace burin
