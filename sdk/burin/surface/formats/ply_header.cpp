// Parses the header of a PLY file [Turk 1994] line by line.
#include <burin/base/error.h>
#include <burin/base/text/lower_case.h>
#include <burin/base/text/quoted_word.h>
#include <burin/surface/files/text_lines.h>
#include <burin/surface/formats/ply_header.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace burin {
namespace {

constexpr std::pair<std::string_view, PlyType> type_names[] = {
    {"char", PlyType::int8},       {"int8", PlyType::int8},      {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},     {"short", PlyType::int16},    {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},   {"uint16", PlyType::uint16},  {"int", PlyType::int32},
    {"int32", PlyType::int32},     {"uint", PlyType::uint32},    {"uint32", PlyType::uint32},
    {"int64", PlyType::int64},     {"uint64", PlyType::uint64},  {"float", PlyType::float32},
    {"float32", PlyType::float32}, {"double", PlyType::float64}, {"float64", PlyType::float64}};

class HeaderReader {
 public:
  HeaderReader(std::string_view text, const std::filesystem::path& path)
      : text_(text), lines_(text), path_(path.string()) {}

  PlyHeader read() {
    if (next_line() != "ply") fail("is not a PLY file: it does not begin with 'ply'");
    const bool ends_in_cr = text_[lines_.offset() - 1] == '\r';
    for (std::string_view line = next_line(); line != "end_header"; line = next_line()) read_line(line);
    if (!has_format_) fail("the header names no format");
    header_.size = lines_.offset();
    // If lines end in CR, an LF after the last one is the first byte of the data.
    if (ends_in_cr && text_.substr(0, header_.size).ends_with("\r\n")) --header_.size;
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(std::string_view what) const {
    throw FileError(path_, std::to_string(lines_.number()), what);
  }

  std::string_view next_line() {
    const std::size_t begin = lines_.offset();
    const auto line = lines_.next();
    // A line that the end of the file cuts short does not count.
    if (!line || begin + line->size() >= text_.size())
      throw FileError(path_, std::to_string(lines_.number() + (line ? 0 : 1)), "the header is cut off");
    return line->substr(0, line->find_last_not_of(" \t") + 1);
  }

  void read_line(std::string_view line) {
    const std::string_view keyword = next_word(line);
    if (keyword.empty() || keyword == "comment" || keyword == "obj_info") return;
    if (keyword == "Created") return;  // by Blender 2.4, which forgot to call it a comment
    if (keyword == "format") return read_format(line);
    if (keyword == "element") return read_element(line);
    if (keyword == "property") return read_property(line);
    fail(fmt::format("{} is not a line of a PLY header", quoted_word(keyword)));
  }

  void read_format(std::string_view line) {
    const std::string_view name = next_word(line);
    if (name == "ascii") {
      header_.format = PlyFormat::ascii;
    } else if (name == "binary_little_endian") {
      header_.format = PlyFormat::little_endian;
    } else if (name == "binary_big_endian") {
      header_.format = PlyFormat::big_endian;
    } else {
      fail(fmt::format("{} is not a PLY format", quoted_word(name)));
    }
    has_format_ = true;
  }

  void read_element(std::string_view line) {
    PlyElement element;
    element.name = next_word(line);
    const std::string_view word = next_word(line);
    const auto count = whole_number(word);
    if (!count || *count < 0) fail(fmt::format("{} is not a number of elements", quoted_word(word)));
    element.count = static_cast<std::uint64_t>(*count);
    header_.elements.push_back(std::move(element));
  }

  void read_property(std::string_view line) {
    if (header_.elements.empty()) fail("a property before the first element");
    PlyProperty property;
    std::string_view type = next_word(line);
    if (type == "list") {
      property.count_type = type_named(next_word(line));
      type = next_word(line);
    }
    property.type = type_named(type);
    property.name = next_word(line);
    if (property.name.empty()) fail("a property without a name");
    header_.elements.back().properties.push_back(std::move(property));
  }

  PlyType type_named(std::string_view name) const {
    const std::string small = in_lower_case(std::string(name));
    for (const auto& [known, type] : type_names)
      if (known == small) return type;
    fail(fmt::format("{} is not a PLY type", quoted_word(name)));
  }

  std::string_view text_;
  TextLines lines_;
  std::string path_;
  bool has_format_ = false;
  PlyHeader header_{};
};

}  // namespace

PlyHeader read_ply_header(std::string_view text, const std::filesystem::path& path) {
  return HeaderReader(text, path).read();
}

const PlyProperty* find_property(const PlyElement& element, std::string_view name) {
  const auto found = std::ranges::find(element.properties, name, &PlyProperty::name);
  return found == element.properties.end() ? nullptr : &*found;
}

}  // namespace burin
