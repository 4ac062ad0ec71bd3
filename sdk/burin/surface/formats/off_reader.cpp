// Reads text files in Geomview's OFF format, with colours and texture coordinates of vertices. Normals and
// colours of faces are counted as unused.
#include <burin/base/error.h>
#include <burin/base/quoted_word.h>
#include <burin/surface/files/file_colours.h>
#include <burin/surface/files/mesh_formats.h>
#include <burin/surface/files/position_line.h>
#include <burin/surface/files/text_lines.h>
#include <burin/surface/files/unused_count.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>

namespace burin {
namespace {

/// The vertex attributes that the first word announces, in Geomview's notation: [ST][C][N]OFF.
struct OffKind {
  bool texture = false, colours = false, normals = false;
};

class OffReader {
 public:
  OffReader(std::string_view text, const std::filesystem::path& path)
      : lines_(text), size_(text.size()), path_(path.string()) {}

  FileMesh read() {
    std::string_view line = next_line();
    read_kind(line);
    if (words(line).empty()) line = next_line();
    read_counts(line);
    for (std::size_t i = 0; i < vertices_; ++i) read_vertex(next_line());
    for (std::size_t i = 0; i < faces_; ++i) read_face(next_line());
    if (kind_.texture)
      for (const Index vertex : file_.mesh.face_vertices) file_.mesh.corner_uv.push_back(uv_[vertex]);
    colours_.give(file_.mesh.paint, vertices_, whole_colours_ ? 255.0 : 1.0, unused_);
    file_.mesh.not_used = unused_.text();
    return std::move(file_);
  }

 private:
  [[noreturn]] void fail(std::string_view what) const {
    throw FileError(path_, std::to_string(lines_.number()), what);
  }

  /// The next line that is not empty.
  std::string_view next_line() {
    while (const auto line = lines_.next_joined())
      if (!words(*line).empty()) return *line;
    fail("the file is cut off");
  }

  static std::vector<std::string_view> words(std::string_view line) {
    std::vector<std::string_view> words;
    for (auto word = next_word(line); !word.empty(); word = next_word(line)) words.push_back(word);
    return words;
  }

  /// Reads the first word and removes it from the line; it is optional.
  void read_kind(std::string_view& line) {
    std::string_view rest = line;
    std::string_view word = next_word(rest);
    if (whole_number(word)) return;
    const std::string_view whole = word;
    const auto take = [&](std::string_view letters) {
      if (!word.starts_with(letters)) return false;
      word.remove_prefix(letters.size());
      return true;
    };
    kind_.texture = take("ST");
    kind_.colours = take("C");
    kind_.normals = take("N");
    if (word == "4OFF" || word == "nOFF" || word == "4nOFF")
      fail("holds points of more than three dimensions");
    if (word != "OFF" && whole != "off")
      fail(fmt::format("is not an OFF file: it begins with {}", quoted_word(whole)));
    line = rest;
    if (next_word(rest) == "BINARY") fail("is a binary OFF file, which is not read");
  }

  void read_counts(std::string_view line) {
    const auto numbers = words(line);
    if (numbers.size() < 2) fail("the numbers of vertices and faces are missing");
    for (std::size_t i = 0; i < 2; ++i) {
      const auto count = whole_number(numbers[i]);
      if (!count || *count < 0) fail(fmt::format("{} is not a number of elements", quoted_word(numbers[i])));
      // Every element has at least two bytes, which limits the memory that a damaged count can request.
      if (static_cast<std::size_t>(*count) > size_) fail(fmt::format("is too short for {} elements", *count));
      (i == 0 ? vertices_ : faces_) = static_cast<std::size_t>(*count);
    }
  }

  double number(std::string_view word) const {
    const auto value = real_number(word);
    if (!value) fail(fmt::format("{} is not a number", quoted_word(word)));
    return *value;
  }

  /// Reads x y z, then the normal, colour and texture coordinates that the kind announces.
  void read_vertex(std::string_view line) {
    Vec3d place;
    if (const std::string fault = read_position(line, place); !fault.empty()) fail(fault);
    const auto numbers = words(line);
    std::size_t at = 0, end = numbers.size();
    if (kind_.normals) {
      at += 3;
      unused_.add("normal", "normals");
    }
    if (kind_.texture) {
      if (end < at + 2) fail("a vertex lacks its texture coordinates");
      end -= 2;
      uv_.emplace_back(static_cast<float>(number(numbers[end])),
                       static_cast<float>(number(numbers[end + 1])));
    }
    if (kind_.colours) read_colour(std::span(numbers).subspan(std::min(at, end), end - std::min(at, end)));
    file_.places.push_back(place);
  }

  void read_colour(std::span<const std::string_view> numbers) {
    if (numbers.size() != 3 && numbers.size() != 4) fail("a vertex lacks its colour: three or four numbers");
    FileColours::Colour colour{0, 0, 0, std::numeric_limits<double>::max()};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      colour[i] = number(numbers[i]);
      whole_colours_ &= whole_number(numbers[i]).has_value();
    }
    colours_.add(file_.places.size(), colour);
  }

  /// Reads the number of corners, their vertices counted from 0, and an optional colour.
  void read_face(std::string_view line) {
    const auto corners = whole_number(next_word(line));
    if (!corners || *corners < 3) fail("a face begins with the number of its corners, three or more");
    for (long long i = 0; i < *corners; ++i) {
      const std::string_view word = next_word(line);
      const auto vertex = whole_number(word);
      if (word.empty()) fail(fmt::format("a face of {} corners names {} vertices", *corners, i));
      if (!vertex || *vertex < 0 || static_cast<std::size_t>(*vertex) >= vertices_)
        fail(fmt::format("names vertex {} of {}, counted from 0", quoted_word(word), vertices_));
      file_.mesh.face_vertices.push_back(static_cast<Index>(*vertex));
    }
    file_.mesh.face_sizes.push_back(static_cast<Index>(*corners));
    if (!next_word(line).empty()) unused_.add("colour of a face", "colours of faces");
  }

  TextLines lines_;
  std::size_t size_;  ///< size of the file, bytes
  std::string path_;
  OffKind kind_;
  std::size_t vertices_ = 0, faces_ = 0;
  FileMesh file_;
  std::vector<Vec2f> uv_;
  FileColours colours_;
  bool whole_colours_ = true;  ///< all channels are whole numbers, so they range to 255; otherwise to 1
  UnusedCount unused_;
};

}  // namespace

FileMesh read_off(const std::filesystem::path& path) {
  const std::string text = read_mesh_bytes(path);
  return OffReader(text, path).read();
}

}  // namespace burin
