#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "system/console.h"

namespace burin {

/// A value in a JSON file with its path, so that errors read "FILE: cases[2].radius: WHAT". All functions
/// that read a value throw FileError if it has another type. Copies share the file's content.
class JsonValue {
 public:
  /// Reads a file. Throws FileError if it cannot be read or is not JSON.
  static JsonValue read(const std::filesystem::path& path);

  /// Parses a text; messages have `name` instead of a file. Throws FileError if it is not JSON.
  static JsonValue parse(std::string_view text, const std::string& name);

  [[noreturn]] void reject(std::string_view what) const;

  /// Throws FileError for the first member of the object that has any other name.
  void allow_only(std::initializer_list<std::string_view> names) const;

  JsonValue member(const std::string& name) const;
  std::optional<JsonValue> find(const std::string& name) const;
  std::vector<JsonValue> items() const;
  std::map<std::string, JsonValue> members() const;

  bool is_text() const;
  bool is_array() const;
  bool is_boolean() const;

  bool boolean() const;
  std::string text() const;
  double number() const;    ///< finite
  double positive() const;  ///< finite, > 0
  std::uint64_t whole(std::uint64_t least, std::uint64_t most) const;
  std::vector<double> numbers() const;

  /// The value that `names` has for this text. Throws FileError, which lists all names, for other texts.
  template <class Value>
  Value choice(const std::map<std::string, Value>& names) const {
    const auto found = names.find(text());
    if (found != names.end()) return found->second;
    std::string all;
    for (const auto& [name, value] : names) all += (all.empty() ? "" : ", ") + name;
    reject("must be one of " + all);
  }

 private:
  struct File;
  JsonValue(std::shared_ptr<const File> file, const Json& json, std::string place)
      : file_(std::move(file)), json_(&json), place_(std::move(place)) {}
  std::string place_of(const std::string& name) const;

  std::shared_ptr<const File> file_;
  const Json* json_;
  std::string place_;
};

}  // namespace burin
