#pragma once
#include <burin/abi/base.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

namespace burin::plugin {

/// The error that a brush throws when it cannot continue; what() is one line that the user reads. The host
/// also receives any other std::exception, as BURIN_ERROR with its what().
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& line, burin_status status = BURIN_ERROR)
      : std::runtime_error(line), status_(status) {}

  burin_status status() const { return status_; }

 private:
  burin_status status_;
};

/// Copies a line into the host's buffer. Truncates a long line between characters, and replaces control
/// characters by spaces so that it stays one line.
inline void write_text(burin_text* text, std::string_view line) noexcept {
  if (!text || !BURIN_HAS(text, burin_text, data) || !text->data || text->capacity == 0) return;
  std::size_t size = std::min<std::size_t>(line.size(), text->capacity - 1);
  const auto continues_character = [&](std::size_t i) { return (line[i] & 0xC0) == 0x80; };
  while (size > 0 && size < line.size() && continues_character(size)) --size;
  std::transform(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(size), text->data,
                 [](char c) { return static_cast<unsigned char>(c) < 0x20 ? ' ' : c; });
  text->data[size] = '\0';
}

/// Runs `body` for a call across the ABI, and turns an exception into a status and a text.
template <class Body>
burin_status guarded(burin_text* text, const Body& body) noexcept {
  try {
    body();
    return BURIN_OK;
  } catch (const Error& error) {
    write_text(text, error.what());
    return error.status();
  } catch (const std::bad_alloc&) {
    write_text(text, "out of memory");
    return BURIN_OUT_OF_MEMORY;
  } catch (const std::exception& error) {
    write_text(text, error.what());
  } catch (...) {
    write_text(text, "the brush threw something that is no std::exception");
  }
  return BURIN_ERROR;
}

}  // namespace burin::plugin
