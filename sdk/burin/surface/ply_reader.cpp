// An own reader because assimp 5.2 never returns from a header that is cut off, and shifts binary data whose
// first byte is a line end (https://github.com/assimp/assimp/issues/5341): one file in 256.
#include <burin/base/error.h>
#include <burin/surface/mesh_formats.h>
#include <burin/surface/ply_header.h>
#include <burin/surface/ply_paint.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <fstream>

namespace burin {
namespace {

std::size_t size_of(PlyType type) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

double value_of(PlyType type, std::uint64_t bits) {
  switch (type) {
    case PlyType::int8:
      return static_cast<std::int8_t>(bits);
    case PlyType::uint8:
      return static_cast<std::uint8_t>(bits);
    case PlyType::int16:
      return static_cast<std::int16_t>(bits);
    case PlyType::uint16:
      return static_cast<std::uint16_t>(bits);
    case PlyType::int32:
      return static_cast<std::int32_t>(bits);
    case PlyType::uint32:
      return static_cast<std::uint32_t>(bits);
    case PlyType::float32:
      return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    case PlyType::float64:
      return std::bit_cast<double>(bits);
  }
  return 0;
}

class PlyReader {
 public:
  PlyReader(std::istream& in, const std::filesystem::path& path)
      : in_(in),
        path_(path.string()),
        size_(std::filesystem::file_size(path)),
        header_(read_ply_header(in, path)) {}

  PolygonMesh read_mesh() {
    read_elements();
    if (!has_vertices_ || !has_faces_) throw FileError(path_, "has no element 'vertex' or no element 'face'");
    return std::move(mesh_);
  }

  PointSet read_points() {
    wants_normals_ = true;
    read_elements();
    if (!has_vertices_) throw FileError(path_, "has no element 'vertex'");
    return {std::move(mesh_.positions), std::move(normals_)};
  }

 private:
  void read_elements() {
    for (const PlyElement& element : header_.elements) {
      // Every element has a byte at least: a damaged count must not ask for memory.
      if (element.count > size_)
        throw FileError(path_, fmt::format("is too short for {} {} elements", element.count, element.name));
      element_ = &element;
      has_vertices_ |= element.name == "vertex";
      has_faces_ |= element.name == "face";
      if (element.name == "vertex") {
        read_vertices();
      } else if (element.name == "face") {
        read_faces();
      } else {
        read_each([](const PlyProperty&, double) {});
      }
    }
  }

  [[noreturn]] void fail(std::string_view what) const {
    throw FileError(path_, fmt::format("{} {}", element_->name, row_ + 1), what);
  }

  void require(std::initializer_list<std::string_view> names, std::string_view what) const {
    for (const PlyProperty& property : element_->properties)
      if (std::find(names.begin(), names.end(), property.name) != names.end()) return;
    throw FileError(path_, fmt::format("its element '{}' has no {}", element_->name, what));
  }

  /// Calls body(property, value) for every number of the element's rows, lengths of lists left out.
  template <class Body>
  void read_each(const Body& body) {
    for (row_ = 0; row_ < element_->count; ++row_)
      for (const PlyProperty& property : element_->properties) {
        const std::uint64_t values = property.count_type ? read_count(*property.count_type) : 1;
        for (std::uint64_t i = 0; i < values; ++i) body(property, read_value(property.type));
      }
  }

  void read_vertices() {
    for (const char* axis : {"x", "y", "z"}) require({axis}, fmt::format("property '{}'", axis));
    mesh_.positions.resize(element_->count);
    if (wants_normals_) {
      for (const char* axis : {"nx", "ny", "nz"}) require({axis}, fmt::format("property '{}'", axis));
      normals_.resize(element_->count);
    }
    PlyPaint painted(*element_);
    read_each([&](const PlyProperty& property, double value) {
      const std::string& name = property.name;
      if (const std::string fault = painted.take(property, row_, value); !fault.empty()) fail(fault);
      const bool is_normal = wants_normals_ && name.size() == 2 && name[0] == 'n';
      if (name.size() != 1 && !is_normal) return;
      const char axis = name.back();
      if (axis < 'x' || axis > 'z') return;
      (is_normal ? normals_ : mesh_.positions)[row_][axis - 'x'] = static_cast<float>(value);
    });
    mesh_.paint = std::move(painted.paint);
  }

  void read_faces() {
    require({"vertex_indices", "vertex_index"}, "list 'vertex_indices'");
    mesh_.face_sizes.resize(element_->count);
    mesh_.face_vertices.reserve(3 * element_->count);
    read_each([&](const PlyProperty& property, double value) {
      if (property.name != "vertex_indices" && property.name != "vertex_index") return;
      if (!(value >= 0 && value < no_index)) fail(fmt::format("names vertex {}", value));
      ++mesh_.face_sizes[row_];
      mesh_.face_vertices.push_back(static_cast<Index>(value));
    });
  }

  std::uint64_t read_count(PlyType type) {
    const double count = read_value(type);
    if (!(count >= 0 && count < 4294967296.0)) fail(fmt::format("has a list of {} entries", count));
    return static_cast<std::uint64_t>(count);
  }

  double read_value(PlyType type) {
    return header_.format == PlyFormat::ascii ? read_word() : read_binary(type);
  }

  double read_word() {
    if (!(in_ >> word_)) fail("the file is cut off");
    double value = 0;
    const char* end = word_.data() + word_.size();
    const auto [stop, error] = std::from_chars(word_.data() + word_.starts_with('+'), end, value);
    if (error != std::errc() || stop != end) fail(fmt::format("'{}' is not a number", word_));
    return value;
  }

  double read_binary(PlyType type) {
    unsigned char bytes[8];
    const auto size = static_cast<std::streamsize>(size_of(type));
    if (in_.rdbuf()->sgetn(reinterpret_cast<char*>(bytes), size) != size) fail("the file is cut off");
    std::uint64_t bits = 0;
    for (std::streamsize i = 0; i < size; ++i)
      bits = bits << 8 | bytes[header_.format == PlyFormat::big_endian ? i : size - 1 - i];
    return value_of(type, bits);
  }

  std::istream& in_;
  std::string path_;
  std::uint64_t size_;  ///< bytes of the file
  PlyHeader header_;
  bool has_vertices_ = false, has_faces_ = false, wants_normals_ = false;
  PolygonMesh mesh_;
  std::vector<Vec3f> normals_;           ///< of the vertices, if wanted
  const PlyElement* element_ = nullptr;  ///< being read, and its row
  std::uint64_t row_ = 0;
  std::string word_;
};

}  // namespace

PolygonMesh read_ply(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return PlyReader(in, path).read_mesh();
}

bool has_ply_faces(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  const PlyHeader header = read_ply_header(in, path);
  return std::ranges::any_of(
      header.elements, [](const PlyElement& element) { return element.name == "face" && element.count > 0; });
}

PointSet read_ply_points(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return PlyReader(in, path).read_points();
}

}  // namespace burin
