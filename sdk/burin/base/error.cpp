// Composes the messages of errors.
#include <burin/base/error.h>
#include <burin/base/text/quoted_word.h>
#include <fmt/format.h>

namespace burin {

FileError::FileError(std::string_view path, std::string_view what)
    : Error(fmt::format("{}: {}", printable(path), what)) {}

FileError::FileError(std::string_view path, std::string_view place, std::string_view what)
    : Error(fmt::format("{}:{}: {}", printable(path), place, what)) {}

}  // namespace burin
