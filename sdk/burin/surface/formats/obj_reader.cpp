// Reads OBJ files. This is our own reader, since tinyobjloader 2.0 reads words that are not numbers as 0,
// counts the corners of a face in a byte and loses the tags after a group.
#include <burin/base/error.h>
#include <burin/base/text/quoted_word.h>
#include <burin/surface/files/file_colours.h>
#include <burin/surface/files/mesh_formats.h>
#include <burin/surface/files/position_line.h>
#include <burin/surface/files/text_lines.h>
#include <burin/surface/files/unused_count.h>
#include <burin/surface/formats/obj_polypaint.h>
#include <burin/surface/formats/obj_tags.h>
#include <fmt/format.h>

#include <algorithm>

namespace burin {
namespace {

/// A kind of elements that faces refer to. A face may refer to elements that come later, so references are
/// checked at the end.
struct Named {
  const char* what;
  std::size_t count = 0;
  long long highest = 0;         ///< highest index in a face
  std::size_t highest_line = 0;  ///< first line with that index
};

class ObjReader {
 public:
  explicit ObjReader(const std::filesystem::path& path) : path_(path.string()) {}

  FileMesh read(std::string_view text) {
    TextLines lines(text);
    while (const auto line = lines.next_joined()) {
      line_ = lines.number();
      read_line(*line);
    }
    check_indices();
    give_texture_coordinates();
    colours_.give(file_.mesh.paint, file_.places.size(), std::nullopt, unused_);
    give_polypaint(ObjPolypaint(text));
    const std::string fault = tags_.give(file_.mesh, file_.places.size(), line_);
    if (!fault.empty()) fail(fault);
    unused_.add("other tag", "other tags", tags_.unknown());
    file_.mesh.not_used = unused_.text();
    return std::move(file_);
  }

 private:
  [[noreturn]] void fail(std::string_view what) const { throw FileError(path_, std::to_string(line_), what); }

  void read_line(std::string_view line) {
    const std::string_view kind = next_word(line);
    if (kind.empty()) return;
    if (kind == "v") return read_vertex(line);
    if (kind == "vt") return read_texture_coordinates(line);
    if (kind == "f" || kind == "fo") return read_face(line);
    if (kind == "t") {
      if (const std::string fault = tags_.take(line, line_); !fault.empty()) fail("tag: " + fault);
      return;
    }
    count_unused(kind, line);
  }

  void count_unused(std::string_view kind, std::string_view line) {
    if (kind == "vn") return unused_.add("normal", "normals");
    if (kind == "l") return unused_.add("line", "lines");
    if (kind == "p") return unused_.add("point", "points");
    if (kind == "mtllib") return;  // the materials are counted where they are used
    const std::string_view name = line.substr(std::min(line.find_first_not_of(" \t"), line.size()));
    if (kind == "usemtl") return unused_.add_named("material", "materials", name);
    if (kind == "o") return unused_.add_named("object", "objects", name);
    if (kind == "g") return unused_.add_named("group", "groups", name);
    if (kind == "s") {
      if (name != "off" && name != "0") unused_.add_named("smoothing group", "smoothing groups", name);
      return;
    }
    unused_.add("other line", "other lines");
  }

  double number(std::string_view word) const {
    const auto value = real_number(word);
    if (!value) fail(fmt::format("{} is not a coordinate", quoted_word(word)));
    return *value;
  }

  /// Reads x y z, then an optional colour with w before it or coverage behind it.
  void read_vertex(std::string_view line) {
    Vec3d place;
    if (const std::string fault = read_position(line, place); !fault.empty()) fail(fault);
    if (file_.places.size() >= no_index) fail("more vertices than can be counted");
    file_.places.push_back(place);
    ++vertices_.count;
    std::array<double, 4> rest{};
    std::size_t numbers = 0;
    for (auto word = next_word(line); !word.empty(); word = next_word(line)) {
      const double value = number(word);
      if (numbers < rest.size()) rest[numbers] = value;
      ++numbers;
    }
    const std::size_t vertex = file_.places.size() - 1;
    if (numbers == 3) colours_.add(vertex, {rest[0], rest[1], rest[2], FileColours::covering});
    if (numbers == 4) colours_.add_four(vertex, rest);
  }

  /// Reads u and v; v is 0 if it is missing.
  void read_texture_coordinates(std::string_view line) {
    ++textures_.count;
    Vec2d uv = Vec2d::Zero();
    auto word = next_word(line);
    if (word.empty()) fail("texture coordinates without a number");
    for (int axis = 0; axis < 2 && !word.empty(); word = next_word(line), ++axis) uv[axis] = number(word);
    uv_.push_back(uv.cast<float>());
  }

  void read_face(std::string_view line) {
    Index corners = 0;
    for (auto word = next_word(line); !word.empty(); word = next_word(line), ++corners) read_corner(word);
    if (corners < 3) fail(fmt::format("a face of {} corners", corners));
    file_.mesh.face_sizes.push_back(corners);
  }

  /// Reads V, V/VT, V//VN or V/VT/VN; the slash of a missing part is allowed.
  void read_corner(std::string_view corner) {
    std::string_view parts[3];
    std::size_t begin = 0;
    for (std::string_view& part : parts) {
      const std::size_t end = std::min(corner.find('/', begin), corner.size());
      part = corner.substr(std::min(begin, corner.size()), end - std::min(begin, corner.size()));
      begin = end + 1;
    }
    if (begin <= corner.size()) fail_corner(corner);
    file_.mesh.face_vertices.push_back(index_of(corner, parts[0], vertices_));
    corner_textures_.push_back(parts[1].empty() ? no_index : index_of(corner, parts[1], textures_));
    if (!parts[2].empty() && whole_number(parts[2]).value_or(0) == 0) fail_corner(corner);
  }

  [[noreturn]] void fail_corner(std::string_view corner) const {
    fail(fmt::format("{} is not a vertex of a face", quoted_word(corner)));
  }

  /// Converts an index to one from 0. Positive indices count from the start of the file, negative ones
  /// backwards from the current line.
  Index index_of(std::string_view corner, std::string_view word, Named& named) {
    const auto index = whole_number(word);
    if (!index || *index == 0) fail_corner(corner);
    if (*index < -static_cast<long long>(named.count))
      fail(fmt::format("the face names {} {} of {} so far", named.what, *index, named.count));
    if (*index < 0) return static_cast<Index>(static_cast<long long>(named.count) + *index);
    if (*index > named.highest) {
      named.highest = *index;
      named.highest_line = line_;
    }
    return static_cast<Index>(*index - 1);
  }

  void check_indices() {
    for (const Named* named : {&vertices_, &textures_}) {
      if (named->highest <= static_cast<long long>(named->count)) continue;
      line_ = named->highest_line;
      fail(fmt::format("the face names {} {} of {}", named->what, named->highest, named->count));
    }
  }

  /// Stores the texture coordinates of all corners, or none if any corner lacks them.
  void give_texture_coordinates() {
    const auto without = static_cast<std::size_t>(std::ranges::count(corner_textures_, no_index));
    if (without == corner_textures_.size())
      return unused_.add("texture coordinate", "texture coordinates", uv_.size());
    if (without > 0)
      return unused_.add("texture coordinate (faces go without)", "texture coordinates (faces go without)",
                         uv_.size());
    for (const Index texture : corner_textures_) file_.mesh.corner_uv.push_back(uv_[texture]);
  }

  /// Stores the colours of comments, unless vertices have colours after their coordinates.
  void give_polypaint(const ObjPolypaint& polypaint) {
    if (polypaint.empty()) return;
    if (file_.mesh.paint.empty() && polypaint.is_of(file_.places.size()))
      file_.mesh.paint = polypaint.paint();
    else
      unused_.add("line of polypaint", "lines of polypaint", polypaint.lines());
  }

  std::string path_;
  std::size_t line_ = 0;
  Named vertices_{"vertex"}, textures_{"texture coordinates"};
  FileMesh file_;
  std::vector<Vec2f> uv_;
  std::vector<Index> corner_textures_;  ///< [corner] index in uv_, or no_index
  FileColours colours_;
  ObjTags tags_;
  UnusedCount unused_;
};

}  // namespace

FileMesh read_obj(const std::filesystem::path& path) {
  const std::string text = read_mesh_bytes(path);
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
    throw FileError(path.string(), "is text in UTF-16; save it as UTF-8");
  return ObjReader(path).read(text);
}

}  // namespace burin
