// Reads STL files, binary and text, as a triangle soup. read_mesh() joins the vertices.
#include <burin/base/error.h>
#include <burin/base/text/lower_case.h>
#include <burin/base/text/quoted_word.h>
#include <burin/surface/files/little_endian.h>
#include <burin/surface/files/mesh_formats.h>
#include <burin/surface/files/position_line.h>
#include <burin/surface/files/text_lines.h>
#include <burin/surface/files/unused_count.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

namespace burin {
namespace {

constexpr std::size_t header_bytes = 84;  ///< 80 bytes of text and the number of triangles
constexpr std::size_t triangle_bytes = 50;

/// The number of triangles that the header of a binary file announces. Programs that write as they go leave 0
/// or -1 there: then it is what follows.
std::size_t announced_triangles(std::string_view bytes) {
  constexpr std::uint32_t unknown = 0xFFFFFFFF;
  const std::uint32_t number = little_endian(bytes, header_bytes - 4);
  const std::size_t behind = bytes.size() - header_bytes;
  const bool whole = behind > 0 && behind % triangle_bytes == 0;
  return (number == 0 || number == unknown) && whole ? behind / triangle_bytes : number;
}

/// The size, in bytes, that a binary file with this number of triangles has; nothing if the file is too short
/// to be binary.
std::optional<std::size_t> binary_size(std::string_view bytes) {
  if (bytes.size() < header_bytes) return std::nullopt;
  return header_bytes + triangle_bytes * announced_triangles(bytes);
}

/// Whether the file starts with "solid" and has no zero byte near the start. Binary files may start with
/// "solid" too, but have zero bytes there.
bool looks_like_text(std::string_view bytes) {
  const std::string_view begin = bytes.substr(0, 512);
  TextLines lines(begin);
  std::string_view word;
  for (auto line = lines.next(); line && word.empty(); line = lines.next()) word = next_word(*line);
  return in_lower_case(std::string(word)) == "solid" && begin.find('\0') == std::string_view::npos;
}

FileMesh read_binary(std::string_view bytes, const std::filesystem::path& path) {
  const std::size_t size = *binary_size(bytes);
  if (bytes.size() < size)
    throw FileError(path.string(), fmt::format("is cut off: its {} triangles need {} bytes, it has {}",
                                               announced_triangles(bytes), size, bytes.size()));
  FileMesh file;
  for (std::size_t at = header_bytes; at < size; at += triangle_bytes) {
    for (std::size_t corner = 1; corner <= 3; ++corner) {
      Vec3d place;
      for (int axis = 0; axis < 3; ++axis)
        place[axis] =
            std::bit_cast<float>(little_endian(bytes, at + 12 * corner + 4 * static_cast<std::size_t>(axis)));
      file.places.push_back(place);
    }
    file.mesh.face_sizes.push_back(3);
  }
  UnusedCount unused;
  unused.add("normal", "normals", file.mesh.face_sizes.size());
  unused.add("byte behind the triangles", "bytes behind the triangles", bytes.size() - size);
  file.mesh.not_used = unused.text();
  return file;
}

/// What a line has behind the name of a solid that begins, or of one that `ended`: files in a single line
/// have a facet there, or another solid. A name may be any words, so "facet" counts only before "normal".
std::string_view behind_name(std::string_view line, bool ended) {
  const auto lower_word = [](std::string_view& text) { return in_lower_case(std::string(next_word(text))); };
  std::string_view solid;
  while (!line.empty()) {
    const std::string_view here = line;
    const std::string word = lower_word(line);
    if (!ended && word == "endsolid") return here;
    if (ended && word == "solid" && solid.empty()) solid = here;
    std::string_view next = line;
    if (word == "facet" && lower_word(next) == "normal") return ended ? solid : here;
  }
  return {};
}

/// What a line has behind a colour.
std::string_view behind_colour(std::string_view line) {
  constexpr std::array<std::string_view, 4> words = {"facet", "outer", "endfacet", "endsolid"};
  while (!line.empty()) {
    const std::string_view here = line;
    if (std::ranges::find(words, in_lower_case(std::string(next_word(line)))) != words.end()) return here;
  }
  return {};
}

/// Reads the text form, in upper or lower case. Normals are skipped, since some programs write words that are
/// not numbers.
class TextReader {
 public:
  TextReader(std::string_view text, const std::filesystem::path& path) : lines_(text), path_(path.string()) {}

  FileMesh read() {
    while (auto line = lines_.next())
      for (auto word = next_word(*line); !word.empty(); word = next_word(*line)) read_word(word, *line);
    if (in_solid_ || corners_ > 0) fail("the file is cut off: its solid does not end");
    unused_.add("normal", "normals", file_.mesh.face_sizes.size());
    file_.mesh.not_used = unused_.text();
    return std::move(file_);
  }

 private:
  [[noreturn]] void fail(std::string_view what) const {
    throw FileError(path_, std::to_string(lines_.number()), what);
  }

  /// Processes a word and removes its arguments from the rest of the line.
  void read_word(std::string_view word, std::string_view& rest) {
    const std::string key = in_lower_case(std::string(word));
    if (key == "outer") {
      normal_words_ = 0;
      next_word(rest);
      return;
    }
    if (normal_words_ > 0) {
      --normal_words_;
      return;
    }
    if (key == "vertex") return read_vertex(rest);
    if (key == "endloop") return end_loop();
    if (key == "endfacet") return;
    if (key == "facet") {
      normal_words_ = 4;
      return;
    }
    if (key == "solid" || key == "endsolid") {
      in_solid_ = key == "solid";
      rest = behind_name(rest, !in_solid_);
      return;
    }
    if (key == "color" || key == "colour") {
      unused_.add("colour", "colours");
      rest = behind_colour(rest);
      return;
    }
    fail(fmt::format("{} is not a word of an STL file", quoted_word(word)));
  }

  void read_vertex(std::string_view& rest) {
    Vec3d place;
    if (const std::string fault = read_position(rest, place); !fault.empty()) fail(fault);
    file_.places.push_back(place);
    ++corners_;
  }

  void end_loop() {
    if (corners_ < 3) fail(fmt::format("a face of {} corners", corners_));
    file_.mesh.face_sizes.push_back(corners_);
    corners_ = 0;
  }

  TextLines lines_;
  std::string path_;
  FileMesh file_;
  UnusedCount unused_;
  bool in_solid_ = false;
  int normal_words_ = 0;  ///< number of words to skip: "normal" and three numbers, on one line or several
  Index corners_ = 0;     ///< number of corners of the loop that is being read
};

FileMesh read_soup(std::string_view bytes, const std::filesystem::path& path) {
  const std::optional<std::size_t> binary = binary_size(bytes);
  if (binary != bytes.size() && looks_like_text(bytes)) return TextReader(bytes, path).read();
  if (!binary) throw FileError(path.string(), "is not an STL file: neither text nor binary");
  return read_binary(bytes, path);
}

}  // namespace

FileMesh read_stl(const std::filesystem::path& path) {
  const std::string bytes = read_mesh_bytes(path);
  FileMesh file = read_soup(bytes, path);
  file.mesh.face_vertices.resize(file.places.size());
  std::iota(file.mesh.face_vertices.begin(), file.mesh.face_vertices.end(), Index{0});
  return file;
}

}  // namespace burin
