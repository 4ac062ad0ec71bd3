#include <burin/base/error.h>
#include <burin/surface/obj_lines.h>
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace burin {
namespace {

/// tinyobjloader counts the corners of a face in a byte.
constexpr int most_corners = 255;

/// Cuts the next word off the front of `line`; empty at its end.
std::string_view next_word(std::string_view& line) {
  constexpr std::string_view space = " \t\r";
  line.remove_prefix(std::min(line.find_first_not_of(space), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(space));
  line.remove_prefix(word.size());
  return word;
}

template <class Number>
std::optional<Number> whole_number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

class LineChecker {
 public:
  explicit LineChecker(const std::filesystem::path& path) : path_(path.string()) {}

  void check(std::string_view line) {
    ++line_;
    const std::string_view kind = next_word(line);
    if (kind == "v") check_vertex(line);
    if (kind == "vt") check_texture_coordinates(line);
    if (kind == "f") check_face(line);
  }

  /// A face may name what comes after it, so this can be told at the end only.
  void check_end() const {
    for (const Named* named : {&vertices_, &textures_})
      if (named->highest > named->count)
        throw FileError(path_, std::to_string(named->highest_line),
                        fmt::format("the face names {} {} of {}", named->what, named->highest, named->count));
  }

 private:
  /// What faces name by numbers.
  struct Named {
    const char* what;
    long long count = 0;
    long long highest = 0;  ///< highest number that a face names, and the first line that does
    long long highest_line = 0;
  };

  [[noreturn]] void fail(std::string_view what) const { throw FileError(path_, std::to_string(line_), what); }

  void check_vertex(std::string_view line) {
    ++vertices_.count;
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view word = next_word(line);
      if (word.empty()) fail("a vertex needs three coordinates");
      check_coordinate(word);
    }
  }

  /// v may be left out, and is 0 then.
  void check_texture_coordinates(std::string_view line) {
    ++textures_.count;
    auto word = next_word(line);
    if (word.empty()) fail("texture coordinates without a number");
    for (int axis = 0; axis < 2 && !word.empty(); word = next_word(line), ++axis) check_coordinate(word);
  }

  void check_coordinate(std::string_view word) const {
    const auto value = whole_number<double>(word);
    if (!value) fail(fmt::format("'{}' is not a coordinate", word));
    if (!(std::abs(*value) <= std::numeric_limits<float>::max()))
      fail(fmt::format("the coordinate '{}' is not finite", word));
  }

  void check_face(std::string_view line) {
    int corners = 0;
    for (auto word = next_word(line); !word.empty(); word = next_word(line), ++corners) check_corner(word);
    if (corners < 3) fail(fmt::format("a face of {} corners", corners));
    if (corners > most_corners)
      fail(fmt::format("a face of {} corners; more than {} cannot be read", corners, most_corners));
  }

  /// A corner is V, V/VT, V//VN or V/VT/VN; what VN names is of no use to us.
  void check_corner(std::string_view corner) {
    const auto slash = corner.find('/');
    check_index(corner, corner.substr(0, slash), vertices_);
    if (slash == std::string_view::npos) return;
    const std::string_view rest = corner.substr(slash + 1);
    if (!rest.starts_with('/')) check_index(corner, rest.substr(0, rest.find('/')), textures_);
  }

  void check_index(std::string_view corner, std::string_view word, Named& named) {
    const auto index = whole_number<long long>(word);
    if (!index || *index == 0) fail(fmt::format("'{}' is not a vertex of a face", corner));
    if (*index < -named.count)
      fail(fmt::format("the face names {} {} of {} so far", named.what, *index, named.count));
    if (*index > named.highest) {
      named.highest = *index;
      named.highest_line = line_;
    }
  }

  std::string path_;
  long long line_ = 0;
  Named vertices_{"vertex"}, textures_{"texture coordinates"};
};

}  // namespace

void check_obj_lines(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  LineChecker checker(path);
  for (std::string line; std::getline(in, line);) checker.check(line);
  if (in.bad()) throw FileError(path.string(), "reading failed");
  checker.check_end();
}

}  // namespace burin
