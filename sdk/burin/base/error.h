#pragma once
#include <stdexcept>
#include <string>
#include <string_view>

namespace burin {

/// Base of everything the SDK throws on purpose. what() is one line of UTF-8 for people.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file cannot be read or written, or its content is wrong. The message is "PATH:PLACE: WHAT", or
/// "PATH: WHAT" without a place (a line, for example). The constructor makes the path printable; callers
/// quote text from the file in WHAT with quoted_word().
class FileError : public Error {
 public:
  FileError(std::string_view path, std::string_view what);
  FileError(std::string_view path, std::string_view place, std::string_view what);
};

/// A caller or a plugin broke a documented contract.
class ContractError : public Error {
 public:
  using Error::Error;
};

}  // namespace burin
