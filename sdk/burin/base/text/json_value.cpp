// Wraps values of nlohmann::json with their paths, so that errors name the place. The line and column of a
// syntax error are counted from the byte at which parsing stopped.
#include <burin/base/file.h>
#include <burin/base/text/json_value.h>
#include <burin/base/text/quoted_word.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace burin {

using Json = nlohmann::json;

struct JsonValue::File {
  std::string name;
  Json content;
};

namespace {

/// A limit below that of other files, since the JSON library needs about twenty times the memory of the text.
constexpr std::uintmax_t most_json_bytes = std::uintmax_t{1} << 26;

/// `at`: the position, from 1, where parsing stopped.
[[noreturn]] void reject_syntax(std::string_view text, std::size_t at, const std::string& file,
                                std::size_t first_line) {
  const std::string_view before = text.substr(0, std::min(at, text.size() + 1) - 1);
  const auto lines = static_cast<std::size_t>(std::ranges::count(before, '\n'));
  throw MalformedJson(file, first_line + lines, at - (before.rfind('\n') + 1));
}

Json parsed(std::string_view text, const std::string& file, std::size_t first_line) {
  // The parser would treat a zero byte as the end of its input.
  std::size_t stopped = text.find('\0') + 1;
  try {
    if (stopped == 0) return Json::parse(text);
  } catch (const Json::parse_error& error) {
    stopped = error.byte;
  }
  reject_syntax(text, stopped, file, first_line);
}

/// A value as messages show it. Values that contain others are not shown: they may be nested too deep for the
/// stack.
std::string shown(const Json& json) {
  if (json.is_structured()) return {};
  return ", not " + (json.is_string() ? quoted_word(json.get<std::string>()) : json.dump());
}

}  // namespace

MalformedJson::MalformedJson(std::string_view file, std::size_t line, std::size_t column)
    : FileError(file, std::to_string(line), fmt::format("malformed JSON at column {}", column)) {}

std::string JsonValue::place_of(const std::string& name) const {
  // Names that the formats define need no quotes, unlike unexpected names in a file.
  const std::string quoted = quoted_word(name), shown = quoted.size() == name.size() + 2 ? name : quoted;
  return place_.empty() ? shown : place_ + "." + shown;
}

JsonValue JsonValue::read(const std::filesystem::path& path) {
  return parse(read_file(path, most_json_bytes), path.string());
}

JsonValue JsonValue::parse(std::string_view text, const std::string& name) {
  return parse(text, name, name, 1);
}

JsonValue JsonValue::parse_line(std::string_view text, const std::string& file, std::size_t line) {
  return parse(text, fmt::format("{}:{}", file, line), file, line);
}

JsonValue JsonValue::parse(std::string_view text, const std::string& name, const std::string& file,
                           std::size_t first_line) {
  try {
    return of(parsed(text, file, first_line), name);
  } catch (const Json::out_of_range&) {
    throw FileError(name, "a number is too large");
  }
}

JsonValue JsonValue::of(Json value, const std::string& name) {
  const auto file = std::make_shared<const File>(File{name, std::move(value)});
  return {file, file->content, ""};
}

void JsonValue::reject(std::string_view what) const {
  if (place_.empty()) throw FileError(file_->name, what);
  throw FileError(file_->name, fmt::format("{}: {}", place_, what));
}

void JsonValue::reject_type(std::string_view expected) const {
  reject(fmt::format("must be {}{}", expected, shown(*json_)));
}

void JsonValue::allow_only(std::span<const std::string_view> names) const {
  for (const auto& [name, value] : members())
    if (std::ranges::find(names, name) == names.end()) value.reject("is not known");
}

std::optional<JsonValue> JsonValue::find(const std::string& name) const {
  if (!json_->is_object()) reject_type("an object");
  const auto found = json_->find(name);
  if (found == json_->end()) return std::nullopt;
  return JsonValue(file_, *found, place_of(name));
}

JsonValue JsonValue::member(const std::string& name) const {
  if (auto value = find(name)) return *std::move(value);
  reject(fmt::format("lacks '{}'", name));
}

JsonValue JsonValue::item(std::size_t index) const {
  return {file_, (*json_)[index], fmt::format("{}[{}]", place_, index)};
}

std::vector<JsonValue> JsonValue::items() const {
  if (!json_->is_array()) reject_type("an array");
  std::vector<JsonValue> items;
  for (std::size_t i = 0; i < json_->size(); ++i) items.push_back(item(i));
  return items;
}

std::map<std::string, JsonValue> JsonValue::members() const {
  if (!json_->is_object()) reject_type("an object");
  std::map<std::string, JsonValue> members;
  for (const auto& [name, value] : json_->items())
    members.emplace(name, JsonValue(file_, value, place_of(name)));
  return members;
}

bool JsonValue::is_object() const { return json_->is_object(); }
bool JsonValue::is_array() const { return json_->is_array(); }
bool JsonValue::is_text() const { return json_->is_string(); }
bool JsonValue::is_boolean() const { return json_->is_boolean(); }
bool JsonValue::is_null() const { return json_->is_null(); }
std::size_t JsonValue::size() const { return json_->size(); }

bool JsonValue::boolean() const {
  if (!json_->is_boolean()) reject_type("true or false");
  return json_->get<bool>();
}

std::string JsonValue::text() const {
  if (!json_->is_string()) reject_type("a text");
  return json_->get<std::string>();
}

double JsonValue::number() const {
  if (json_->is_number() && std::isfinite(json_->get<double>())) return json_->get<double>();
  reject_type("a number");
}

double JsonValue::positive() const {
  if (json_->is_number() && json_->get<double>() > 0) return number();
  reject_type("a number above 0");
}

std::uint64_t JsonValue::whole(std::uint64_t least, std::uint64_t most) const {
  // Literals that are not negative are parsed as unsigned numbers.
  if (json_->is_number_unsigned() && *json_ >= least && *json_ <= most) return json_->get<std::uint64_t>();
  reject_type(fmt::format("a whole number from {} to {}", least, most));
}

std::vector<double> JsonValue::numbers() const {
  if (!json_->is_array()) reject_type("an array of numbers");
  std::vector<double> numbers;
  numbers.reserve(json_->size());
  for (std::size_t i = 0; i < json_->size(); ++i) numbers.push_back(number_at(i));
  return numbers;
}

double JsonValue::number_at(std::size_t index) const {
  const Json& value = (*json_)[index];
  // Paths are made for messages only, since making them would take longer than reading the numbers.
  if (value.is_number() && std::isfinite(value.get<double>())) return value.get<double>();
  return item(index).number();
}

}  // namespace burin
