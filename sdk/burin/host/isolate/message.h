#pragma once
#include <burin/base/error.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace burin::isolate {

using Bytes = std::vector<std::byte>;

/// Appends values to a message between processes of one machine and one build.
class MessageWriter {
 public:
  template <class Value>
  MessageWriter& value(const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    return raw(&value, sizeof value);
  }
  MessageWriter& block(std::span<const std::byte> bytes) {
    value(std::uint64_t{bytes.size()});
    return raw(bytes.data(), bytes.size());
  }
  MessageWriter& text(std::string_view text) { return block(std::as_bytes(std::span(text))); }

  const Bytes& bytes() const { return bytes_; }

 private:
  MessageWriter& raw(const void* data, std::size_t size) {
    if (size == 0) return *this;
    const std::size_t before = bytes_.size();
    bytes_.resize(before + size);
    std::memcpy(bytes_.data() + before, data, size);
    return *this;
  }

  Bytes bytes_;
};

/// Reads what a MessageWriter wrote. The other process may have written anything: every function throws Error
/// if the message ends before the value does.
class MessageReader {
 public:
  /// The bytes must outlive the reader.
  explicit MessageReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <class Value>
  Value value() {
    static_assert(std::is_trivially_copyable_v<Value>);
    Value value{};
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  std::span<const std::byte> block() { return take(value<std::uint64_t>()); }
  std::string text() {
    const std::span<const std::byte> bytes = block();
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }

  /// A count of things of which each takes at least `bytes` of the rest.
  std::uint32_t count(std::size_t bytes) {
    const auto count = value<std::uint32_t>();
    if (count > rest_.size() / bytes) throw damaged();
    return count;
  }
  std::size_t left() const { return rest_.size(); }

 private:
  static Error damaged() { return Error("what came from the brush's process is damaged"); }

  std::span<const std::byte> take(std::uint64_t size) {
    if (size > rest_.size()) throw damaged();
    const auto taken = rest_.first(static_cast<std::size_t>(size));
    rest_ = rest_.subspan(static_cast<std::size_t>(size));
    return taken;
  }

  std::span<const std::byte> rest_;
};

/// One line for people made of text from the other process: at most `most` bytes, without controls and
/// without what is no UTF-8.
std::string shown_text(std::string_view text, std::size_t most = 1000);

}  // namespace burin::isolate
