#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <burin/base/error.h>

namespace burin {

/// A text that is not JSON. The message reads "FILE:LINE: malformed JSON at column COLUMN".
class MalformedJson : public FileError {
 public:
  MalformedJson(std::string_view file, std::size_t line, std::size_t column);
};

/// A value in a JSON text with its path, so that errors read "FILE: cases[2].radius: WHAT". All functions
/// that read a value throw FileError if it has another type. Copies share the content of the text.
class JsonValue {
 public:
  /// Reads a file. Throws FileError if it cannot be read or is larger than 64 MiB, and MalformedJson.
  static JsonValue read(const std::filesystem::path& path);

  /// Parses a text; messages have `name` instead of a file. Throws MalformedJson, and FileError for numbers
  /// that are too large for a double.
  static JsonValue parse(std::string_view text, const std::string& name);

  /// Parses one line of a file, counted from 1; messages name it as "FILE:LINE".
  static JsonValue parse_line(std::string_view text, const std::string& file, std::size_t line);

  /// Wraps a value that is parsed already; messages have `name` instead of a file.
  static JsonValue of(nlohmann::json value, const std::string& name);

  [[noreturn]] void reject(std::string_view what) const;

  /// Throws FileError for the first member of the object that has any other name.
  void allow_only(std::span<const std::string_view> names) const;

  JsonValue member(const std::string& name) const;
  std::optional<JsonValue> find(const std::string& name) const;
  std::vector<JsonValue> items() const;
  std::map<std::string, JsonValue> members() const;

  bool is_object() const;
  bool is_array() const;
  bool is_text() const;
  bool is_boolean() const;
  bool is_null() const;
  std::size_t size() const;  ///< of an array

  bool boolean() const;
  std::string text() const;
  double number() const;    ///< finite
  double positive() const;  ///< finite, > 0
  std::uint64_t whole(std::uint64_t least, std::uint64_t most) const;
  std::vector<double> numbers() const;
  double number_at(std::size_t index) const;  ///< of an array that has such an element; finite

  /// The value that `names` has for this text. Throws FileError, which lists all names, for other values.
  template <class Value>
  Value choice(const std::map<std::string, Value>& names) const {
    const auto found = is_text() ? names.find(text()) : names.end();
    if (found != names.end()) return found->second;
    std::string all;
    for (const auto& [name, value] : names) all += (all.empty() ? "" : ", ") + name;
    reject_type("one of " + all);
  }

  /// "must be EXPECTED, not VALUE".
  [[noreturn]] void reject_type(std::string_view expected) const;

 private:
  struct File;
  JsonValue(std::shared_ptr<const File> file, const nlohmann::json& json, std::string place)
      : file_(std::move(file)), json_(&json), place_(std::move(place)) {}
  static JsonValue parse(std::string_view text, const std::string& name, const std::string& file,
                         std::size_t first_line);
  JsonValue item(std::size_t index) const;
  std::string place_of(const std::string& name) const;

  std::shared_ptr<const File> file_;
  const nlohmann::json* json_;
  std::string place_;
};

}  // namespace burin
