#include <burin/base/error.h>
#include <burin/surface/ply_header.h>
#include <fmt/format.h>

#include <charconv>
#include <sstream>
#include <utility>

namespace burin {
namespace {

constexpr std::pair<std::string_view, PlyType> type_names[] = {
    {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
    {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
    {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
    {"float64", PlyType::float64}};

class HeaderReader {
 public:
  HeaderReader(std::istream& in, const std::filesystem::path& path) : in_(in), path_(path.string()) {}

  PlyHeader read() {
    if (next_line() != "ply") fail("is not a PLY file: it does not begin with 'ply'");
    for (std::string line = next_line(); line != "end_header"; line = next_line()) read_line(line);
    if (!has_format_) fail("the header names no format");
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(std::string_view what) const { throw FileError(path_, std::to_string(line_), what); }

  std::string next_line() {
    std::string line;
    ++line_;
    if (!std::getline(in_, line)) fail("the header is cut off");
    const std::size_t end = line.find_last_not_of(" \t\r");
    line.resize(end == std::string::npos ? 0 : end + 1);
    return line;
  }

  void read_line(const std::string& line) {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    if (keyword.empty() || keyword == "comment" || keyword == "obj_info") return;
    if (keyword == "format") return read_format(words);
    if (keyword == "element") return read_element(words);
    if (keyword == "property") return read_property(words);
    fail(fmt::format("'{}' is not a line of a PLY header", keyword));
  }

  void read_format(std::istringstream& words) {
    std::string name;
    words >> name;
    if (name == "ascii") {
      header_.format = PlyFormat::ascii;
    } else if (name == "binary_little_endian") {
      header_.format = PlyFormat::little_endian;
    } else if (name == "binary_big_endian") {
      header_.format = PlyFormat::big_endian;
    } else {
      fail(fmt::format("'{}' is not a PLY format", name));
    }
    has_format_ = true;
  }

  void read_element(std::istringstream& words) {
    PlyElement element;
    std::string count;
    words >> element.name >> count;
    const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), element.count);
    if (count.empty() || error != std::errc() || end != count.data() + count.size())
      fail(fmt::format("'{}' is not a number of elements", count));
    header_.elements.push_back(std::move(element));
  }

  void read_property(std::istringstream& words) {
    if (header_.elements.empty()) fail("a property before the first element");
    std::string type;
    words >> type;
    PlyProperty property;
    if (type == "list") {
      words >> type;
      property.count_type = type_named(type);
      words >> type;
    }
    property.type = type_named(type);
    if (!(words >> property.name)) fail("a property without a name");
    header_.elements.back().properties.push_back(std::move(property));
  }

  PlyType type_named(std::string_view name) const {
    for (const auto& [known, type] : type_names)
      if (known == name) return type;
    fail(fmt::format("'{}' is not a PLY type", name));
  }

  std::istream& in_;
  std::string path_;
  int line_ = 0;
  bool has_format_ = false;
  PlyHeader header_{};
};

}  // namespace

PlyHeader read_ply_header(std::istream& in, const std::filesystem::path& path) {
  return HeaderReader(in, path).read();
}

}  // namespace burin
