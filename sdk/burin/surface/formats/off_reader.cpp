// Reads text files in Geomview's OFF format, with colours and texture coordinates of vertices. Normals and
// colours of faces are counted as unused.
//
// The format is a sequence of words, whatever lines they stand in. Only the colour of a face needs its line:
// it is what follows the corners up to the end of it, in any number. So what is left of a line behind a face
// is taken for the start of another one only if the lines that follow are too few for all others.
#include <burin/base/error.h>
#include <burin/base/text/quoted_word.h>
#include <burin/surface/files/file_colours.h>
#include <burin/surface/files/mesh_formats.h>
#include <burin/surface/files/position_line.h>
#include <burin/surface/files/text_lines.h>
#include <burin/surface/files/unused_count.h>
#include <burin/surface/formats/off_words.h>
#include <fmt/format.h>

#include <limits>

namespace burin {
namespace {

/// The vertex attributes that the first word announces, in Geomview's notation: [ST][C][N]OFF.
struct OffKind {
  bool texture = false, colours = false, normals = false;
};

class OffReader {
 public:
  OffReader(std::string_view text, const std::filesystem::path& path)
      : words_(text), size_(text.size()), path_(path.string()) {}

  FileMesh read() {
    read_kind();
    read_counts();
    by_lines_ = words_.left_of_line() == 0 && words_.lines_left() == elements_left_;
    for (std::size_t i = 0; i < vertices_; ++i) read_vertex();
    for (std::size_t i = 0; i < faces_; ++i) read_face();
    if (kind_.texture)
      for (const Index vertex : file_.mesh.face_vertices) file_.mesh.corner_uv.push_back(uv_[vertex]);
    colours_.give(file_.mesh.paint, vertices_, whole_colours_ ? 255.0 : 1.0, unused_);
    file_.mesh.not_used = unused_.text();
    return std::move(file_);
  }

 private:
  [[noreturn]] void fail(std::string_view what) const {
    throw FileError(path_, std::to_string(words_.line_number()), what);
  }

  void begin() {
    if (!words_.go_on()) fail("the file is cut off");
  }

  /// The next word of an element; empty where the element is cut off.
  std::string_view next() { return by_lines_ ? words_.next_of_line() : words_.next(); }

  /// Goes behind an element. Returns how many words of its line belong to no other one; only faces have such
  /// words in whatever lines.
  std::size_t end_element(bool face) {
    --elements_left_;
    if (!by_lines_ && !(face && elements_left_ <= words_.lines_left())) return 0;
    const std::size_t extra = words_.left_of_line();
    words_.skip_line();
    return extra;
  }

  /// Reads the first word, which is optional. Some programs write the number of vertices right behind it.
  void read_kind() {
    begin();
    OffWords ahead = words_;
    const std::string whole(ahead.next());
    if (whole_number(whole)) return;
    std::string_view word = whole;
    const auto take = [&](std::string_view letters) {
      if (!word.starts_with(letters)) return false;
      word.remove_prefix(letters.size());
      return true;
    };
    kind_.texture = take("ST");
    kind_.colours = take("C");
    kind_.normals = take("N");
    if (word == "nOFF" && ahead.next() == "3") word = "OFF";  // the number of dimensions comes next
    if (word == "4OFF" || word == "nOFF" || word == "4nOFF")
      fail("holds points of more than three dimensions");
    const bool known = take("OFF") || (word == whole && take("off"));
    if (!known || (!word.empty() && !whole_number(word)))
      fail(fmt::format("is not an OFF file: it begins with {}", quoted_word(whole)));
    words_ = ahead;
    counted_ = !word.empty();
    if (counted_) vertices_ = count(word);
    if (ahead.next_of_line() == "BINARY") fail("is a binary OFF file, which is not read");
  }

  std::size_t count(std::string_view word) const {
    if (word.empty()) fail("the numbers of vertices and faces are missing");
    const auto count = whole_number(word);
    if (!count || *count < 0) fail(fmt::format("{} is not a number of elements", quoted_word(word)));
    // Every element has at least two bytes, which limits the memory that a damaged count can request.
    if (static_cast<std::size_t>(*count) > size_) fail(fmt::format("is too short for {} elements", *count));
    return static_cast<std::size_t>(*count);
  }

  /// Reads the numbers of vertices and faces, and goes behind that of edges, which some programs leave out.
  void read_counts() {
    if (!counted_) vertices_ = count(words_.next());
    faces_ = count(words_.next());
    elements_left_ = vertices_ + faces_;
    const bool edges = words_.left_of_line() > 0 || (words_.go_on() && words_.left_of_line() == 1);
    if (edges) words_.next();
  }

  double number(std::string_view word) const {
    const auto value = real_number(word);
    if (!value) fail(fmt::format("{} is not a number", quoted_word(word)));
    return *value;
  }

  /// Reads x y z, then the normal, colour and texture coordinates that the kind announces.
  void read_vertex() {
    begin();
    const std::size_t on_line = words_.left_of_line();
    Vec3d place;
    for (double& coordinate : place)
      if (const std::string fault = read_coordinate(next(), coordinate); !fault.empty()) fail(fault);
    if (kind_.normals) {
      for (int axis = 0; axis < 3; ++axis) number(next());
      unused_.add("normal", "normals");
    }
    if (kind_.colours) read_colour(on_line);
    if (kind_.texture) read_texture();
    file_.places.push_back(place);
    if (const std::size_t extra = end_element(false); extra > 0)
      unused_.add("other number of a vertex", "other numbers of vertices", extra);
  }

  /// Reads four channels, or three if the line of the vertex has only so many numbers.
  void read_colour(std::size_t on_line) {
    const std::size_t others = 3 + (kind_.normals ? 3 : 0) + (kind_.texture ? 2 : 0);
    FileColours::Colour colour{0, 0, 0, std::numeric_limits<double>::max()};
    for (std::size_t i = 0; i < (on_line == others + 3 ? 3U : 4U); ++i) {
      const std::string_view word = next();
      if (word.empty()) fail("a vertex lacks its colour: three or four numbers");
      colour[i] = number(word);
      whole_colours_ &= whole_number(word).has_value();
    }
    colours_.add(file_.places.size(), colour);
  }

  void read_texture() {
    Vec2f uv;
    for (float& coordinate : uv) {
      const std::string_view word = next();
      if (word.empty()) fail("a vertex lacks its texture coordinates");
      coordinate = static_cast<float>(number(word));
    }
    uv_.push_back(uv);
  }

  /// Reads the number of corners, their vertices counted from 0, and an optional colour. Files have points
  /// and edges as faces of one corner and two.
  void read_face() {
    begin();
    const auto corners = whole_number(next());
    if (!corners || *corners < 1) fail("a face begins with the number of its corners");
    for (long long i = 0; i < *corners; ++i) {
      const std::string_view word = next();
      const auto vertex = whole_number(word);
      if (word.empty()) fail(fmt::format("a face of {} corners names {} vertices", *corners, i));
      if (!vertex || *vertex < 0 || static_cast<std::size_t>(*vertex) >= vertices_)
        fail(fmt::format("names vertex {} of {}, counted from 0", quoted_word(word), vertices_));
      if (*corners >= 3) file_.mesh.face_vertices.push_back(static_cast<Index>(*vertex));
    }
    if (*corners >= 3)
      file_.mesh.face_sizes.push_back(static_cast<Index>(*corners));
    else
      unused_.add("face of fewer than three corners", "faces of fewer than three corners");
    if (end_element(true) > 0) unused_.add("colour of a face", "colours of faces");
  }

  OffWords words_;
  std::size_t size_;  ///< size of the file, bytes
  std::string path_;
  OffKind kind_;
  std::size_t vertices_ = 0, faces_ = 0;
  std::size_t elements_left_ = 0;  ///< vertices and faces that are not read yet
  bool counted_ = false;           ///< the first word had the number of vertices
  bool by_lines_ = false;          ///< each element has a line, so it ends there even if it is cut off
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
