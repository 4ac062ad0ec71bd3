// Reads PLY files. This is our own reader, since assimp 5.2 never returns from a truncated header, and shifts
// binary data whose first byte is a line end (https://github.com/assimp/assimp/issues/5341), which is one
// file in 256.
#include <burin/base/error.h>
#include <burin/surface/files/mesh_formats.h>
#include <burin/surface/files/unused_count.h>
#include <burin/surface/formats/ply_header.h>
#include <burin/surface/formats/ply_paint.h>
#include <burin/surface/formats/ply_texture.h>
#include <burin/surface/formats/ply_values.h>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace burin {
namespace {

constexpr std::string_view vertex_lists[] = {"vertex_indices", "vertex_index"};

bool is_vertex_list(const PlyProperty& property) {
  return property.count_type && std::ranges::find(vertex_lists, property.name) != std::end(vertex_lists);
}

class PlyReader {
 public:
  PlyReader(const std::string& text, const std::filesystem::path& path)
      : path_(path.string()),
        size_(text.size()),
        header_(read_ply_header(text, path)),
        values_(std::string_view(text).substr(header_.size), header_.format) {}

  FileMesh read_mesh() {
    read_elements();
    if (!has_vertices_) throw FileError(path_, "has no element 'vertex'");
    if (!has_faces_ && has_grid_)
      throw FileError(path_, "holds a range grid, which is not read: join its points to faces first");
    if (!has_faces_) throw FileError(path_, "has no element 'face' or 'tristrips'");
    PolygonMesh& mesh = file_.mesh;
    mesh.corner_uv = texture_.of_corners(mesh.face_vertices);
    if (mesh.corner_uv.empty()) unused_.add("texture coordinate", "texture coordinates", texture_.count());
    unused_.add("normal", "normals", normals_.size());
    mesh.not_used = unused_.text();
    return std::move(file_);
  }

  FilePoints read_points() {
    read_elements();
    if (!has_vertices_) throw FileError(path_, "has no element 'vertex'");
    if (normals_.size() != file_.places.size())
      throw FileError(path_, "its element 'vertex' has no normals: properties 'nx', 'ny' and 'nz'");
    return {std::move(file_.places), std::move(normals_)};
  }

 private:
  void read_elements() {
    for (const PlyElement& element : header_.elements) {
      // Every element has at least one byte, which limits the memory that a damaged count can request.
      if (element.count > size_)
        throw FileError(path_, fmt::format("is too short for {} {} elements", element.count, element.name));
      element_ = &element;
      try {
        read_element();
      } catch (const FileError&) {
        throw;
      } catch (const Error& error) {
        fail(error.what());
      }
    }
  }

  void read_element() {
    const std::string& name = element_->name;
    if (name == "vertex") return read_vertices();
    if (name == "face") return read_faces();
    if (name == "tristrips") return read_strips();
    has_grid_ |= name == "range_grid";
    name == "edge" ? unused_.add("edge", "edges", element_->count)
                   : unused_.add("other element", "other elements", element_->count);
    read_rows([](std::size_t, double) {}, [] {});
  }

  [[noreturn]] void fail(std::string_view what) const {
    throw FileError(path_, fmt::format("{} {}", element_->name, row_ + 1), what);
  }

  [[noreturn]] void fail_without(std::string_view what) const {
    throw FileError(path_, fmt::format("its element '{}' has no {}", element_->name, what));
  }

  /// Calls take(index of the property, value) for every number in the element's rows except the lengths of
  /// lists, and end_row() after each row.
  template <class Take, class EndRow>
  void read_rows(const Take& take, const EndRow& end_row) {
    for (row_ = 0; row_ < element_->count; ++row_) {
      for (std::size_t i = 0; i < element_->properties.size(); ++i) {
        const PlyProperty& property = element_->properties[i];
        const std::uint64_t count = property.count_type ? values_.next_count(*property.count_type) : 1;
        for (std::uint64_t k = 0; k < count; ++k) take(i, values_.next(property.type));
      }
      end_row();
    }
  }

  /// The index of a property that is not a list, or the number of properties if there is none with this name.
  std::size_t scalar(std::string_view name) const {
    const PlyProperty* found = find_property(*element_, name);
    return found && !found->count_type ? static_cast<std::size_t>(found - element_->properties.data())
                                       : element_->properties.size();
  }

  void read_vertices() {
    has_vertices_ = true;
    std::vector<double*> targets(element_->properties.size() + 1, nullptr);
    Vec3d place, normal;
    std::size_t axes_of_normal = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const std::string name(1, static_cast<char>('x' + axis));
      if (scalar(name) == element_->properties.size()) fail_without(fmt::format("property '{}'", name));
      targets[scalar(name)] = &place[axis];
      targets[scalar("n" + name)] = &normal[axis];
      axes_of_normal += scalar("n" + name) < element_->properties.size();
    }
    PlyPaint painted(*element_);
    const std::vector<PlyTexture::Slot> slots = PlyTexture::vertex_slots(*element_);
    texture_.begin_vertices(element_->count, std::ranges::any_of(slots, is_used));
    for (std::size_t i = 0; i < slots.size(); ++i)
      if (!targets[i] && !is_used(slots[i]) && !painted.takes(i)) count_unused_property(i);
    file_.places.reserve(element_->count);
    read_rows(
        [&](std::size_t i, double value) {
          if (targets[i]) *targets[i] = value;
          texture_.take(slots[i], row_, value);
          if (const std::string fault = painted.take(i, row_, value); !fault.empty()) fail(fault);
        },
        [&] {
          file_.places.push_back(place);
          if (axes_of_normal == 3) normals_.push_back(normal.cast<float>());
        });
    if (const auto fault = painted.settle_reals()) {
      row_ = fault->vertex;
      fail(fault->message);
    }
    file_.mesh.paint = painted.finish();
  }

  static bool is_used(PlyTexture::Slot slot) { return slot != PlyTexture::Slot::none; }

  void count_unused_property(std::size_t i) {
    unused_.add_named("other property", "other properties",
                      element_->name + ' ' + element_->properties[i].name);
  }

  void read_faces() {
    has_faces_ = true;
    PolygonMesh& mesh = file_.mesh;
    const std::size_t list = vertex_list();
    const std::vector<PlyTexture::Slot> slots = PlyTexture::face_slots(*element_);
    for (std::size_t i = 0; i < slots.size(); ++i)
      if (i != list && !is_used(slots[i])) count_unused_property(i);
    mesh.face_sizes.reserve(element_->count);
    Index corners = 0;
    read_rows(
        [&](std::size_t i, double value) {
          if (i == list) {
            mesh.face_vertices.push_back(vertex_of(value));
            ++corners;
          } else {
            texture_.take_of_face(slots[i], value);
          }
        },
        [&] {
          mesh.face_sizes.push_back(corners);
          texture_.end_face(corners);
          corners = 0;
        });
  }

  /// Reads triangle strips: each vertex forms a triangle with the two before it, with alternating
  /// orientation; -1 starts the next strip.
  void read_strips() {
    has_faces_ = true;
    const std::size_t list = vertex_list();
    std::vector<Index> strip;
    const auto end_strip = [&] { strip.clear(); };
    read_rows(
        [&](std::size_t i, double value) {
          if (i != list) return;
          if (value == -1) return end_strip();
          strip.push_back(vertex_of(value));
          if (strip.size() >= 3) add_triangle(strip);
        },
        end_strip);
  }

  /// Adds the triangle of the last three vertices. One that has a vertex twice is left out, but still changes
  /// the orientation of the next.
  void add_triangle(const std::vector<Index>& strip) {
    const std::size_t at = strip.size() - 3;
    const Index a = strip[at], b = strip[at + 1], c = strip[at + 2];
    if (a == b || b == c || c == a) return;
    const bool turned = at % 2 == 1;
    file_.mesh.face_sizes.push_back(3);
    for (const Index vertex : {a, turned ? c : b, turned ? b : c}) file_.mesh.face_vertices.push_back(vertex);
  }

  std::size_t vertex_list() const {
    const auto found = std::ranges::find_if(element_->properties, is_vertex_list);
    if (found == element_->properties.end()) fail_without("list 'vertex_indices'");
    return static_cast<std::size_t>(found - element_->properties.begin());
  }

  Index vertex_of(double value) const {
    if (!(value >= 0 && value < no_index)) fail(fmt::format("names vertex {}", value));
    return static_cast<Index>(value);
  }

  std::string path_;
  std::size_t size_;  ///< size of the file, bytes
  PlyHeader header_;
  PlyValues values_;
  bool has_vertices_ = false, has_faces_ = false, has_grid_ = false;
  FileMesh file_;
  std::vector<Vec3f> normals_;  ///< [vertex], or empty
  PlyTexture texture_;
  UnusedCount unused_;
  const PlyElement* element_ = nullptr;  ///< the element that is being read
  std::uint64_t row_ = 0;                ///< its current row
};

/// Reads the start of a file, at least to the end of its header.
std::string read_header_text(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::string text, chunk(65536, '\0');
  while (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size())), in.gcount() > 0) {
    text.append(chunk, 0, static_cast<std::size_t>(in.gcount()));
    const std::size_t end = text.find("end_header");
    if (end != std::string::npos && end + 12 < text.size()) break;
  }
  return text;
}

}  // namespace

FileMesh read_ply(const std::filesystem::path& path) {
  const std::string text = read_mesh_bytes(path);
  return PlyReader(text, path).read_mesh();
}

bool has_ply_faces(const std::filesystem::path& path) {
  const std::string text = read_header_text(path);
  const PlyHeader header = read_ply_header(text, path);
  return std::ranges::any_of(header.elements, [](const PlyElement& element) {
    return element.count > 0 &&
           (element.name == "face" || element.name == "tristrips" || element.name == "range_grid");
  });
}

FilePoints read_ply_points(const std::filesystem::path& path) {
  const std::string text = read_mesh_bytes(path);
  return PlyReader(text, path).read_points();
}

}  // namespace burin
