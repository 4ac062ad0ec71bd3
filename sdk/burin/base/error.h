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

/// Something is wrong with a file. The message reads "PATH:PLACE: WHAT", or "PATH: WHAT" without a place;
/// the path is made printable (quoted_word.h), the words of the file in WHAT are for the thrower to quote.
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
