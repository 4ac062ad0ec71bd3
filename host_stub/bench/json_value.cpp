#include "bench/json_value.h"

#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/base/quoted_word.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace burin {

struct JsonValue::File {
  std::string name;
  Json content;
};

namespace {

constexpr std::uintmax_t most_json_bytes = std::uintmax_t{1} << 26;

}  // namespace

std::string JsonValue::place_of(const std::string& name) const {
  // Names that the formats define need no quotes, unlike unexpected names in a file.
  const std::string quoted = quoted_word(name), shown = quoted.size() == name.size() + 2 ? name : quoted;
  return place_.empty() ? shown : place_ + "." + shown;
}

JsonValue JsonValue::read(const std::filesystem::path& path) {
  return parse(read_file(path, most_json_bytes), path.string());
}

JsonValue JsonValue::parse(std::string_view text, const std::string& name) {
  auto file = std::make_shared<File>();
  file->name = name;
  try {
    file->content = Json::parse(text);
  } catch (const Json::parse_error& error) {
    const auto broken = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    throw FileError(name, std::to_string(1 + std::count(text.begin(), broken, '\n')), "malformed JSON");
  } catch (const Json::out_of_range&) {
    throw FileError(name, "a number is too large");
  }
  const Json& content = file->content;
  return {std::move(file), content, ""};
}

void JsonValue::reject(std::string_view what) const {
  if (place_.empty()) throw FileError(file_->name, what);
  throw FileError(file_->name, fmt::format("{}: {}", place_, what));
}

void JsonValue::allow_only(std::initializer_list<std::string_view> names) const {
  for (const auto& [name, value] : members())
    if (std::find(names.begin(), names.end(), name) == names.end()) value.reject("is not known");
}

std::optional<JsonValue> JsonValue::find(const std::string& name) const {
  if (!json_->is_object()) reject("must be an object");
  const auto found = json_->find(name);
  if (found == json_->end()) return std::nullopt;
  return JsonValue(file_, *found, place_of(name));
}

JsonValue JsonValue::member(const std::string& name) const {
  if (auto value = find(name)) return *std::move(value);
  reject(fmt::format("lacks '{}'", name));
}

std::vector<JsonValue> JsonValue::items() const {
  if (!json_->is_array()) reject("must be an array");
  std::vector<JsonValue> items;
  for (std::size_t i = 0; i < json_->size(); ++i)
    items.push_back(JsonValue(file_, (*json_)[i], fmt::format("{}[{}]", place_, i)));
  return items;
}

std::map<std::string, JsonValue> JsonValue::members() const {
  if (!json_->is_object()) reject("must be an object");
  std::map<std::string, JsonValue> members;
  for (const auto& [name, value] : json_->items())
    members.emplace(name, JsonValue(file_, value, place_of(name)));
  return members;
}

bool JsonValue::is_text() const { return json_->is_string(); }
bool JsonValue::is_array() const { return json_->is_array(); }
bool JsonValue::is_boolean() const { return json_->is_boolean(); }
bool JsonValue::boolean() const { return json_->get<bool>(); }

std::string JsonValue::text() const {
  if (!json_->is_string()) reject("must be a text");
  return json_->get<std::string>();
}

double JsonValue::number() const {
  if (!json_->is_number()) reject("must be a number");
  return json_->get<double>();
}

double JsonValue::positive() const {
  if (json_->is_number() && json_->get<double>() > 0) return json_->get<double>();
  reject("must be a number above 0");
}

std::uint64_t JsonValue::whole(std::uint64_t least, std::uint64_t most) const {
  // Literals that are not negative are parsed as unsigned numbers.
  if (json_->is_number_unsigned() && *json_ >= least && *json_ <= most) return json_->get<std::uint64_t>();
  reject(fmt::format("must be a whole number from {} to {}", least, most));
}

std::vector<double> JsonValue::numbers() const {
  std::vector<double> numbers;
  for (const JsonValue& item : items()) numbers.push_back(item.number());
  return numbers;
}

}  // namespace burin
