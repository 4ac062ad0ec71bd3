#include <burin/base/error.h>
#include <fmt/format.h>

namespace burin {

FileError::FileError(std::string_view path, std::string_view what)
    : Error(fmt::format("{}: {}", path, what)) {}

FileError::FileError(std::string_view path, std::string_view place, std::string_view what)
    : Error(fmt::format("{}:{}: {}", path, place, what)) {}

}  // namespace burin
