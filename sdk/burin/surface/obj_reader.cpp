#include <burin/base/error.h>
#include <burin/surface/mesh_formats.h>
#include <burin/surface/obj_lines.h>
#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <fstream>

namespace burin {
namespace {

struct ObjContents {
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
};

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

ObjContents load(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  ObjContents contents;
  std::vector<tinyobj::material_t> materials;
  std::string warnings, errors;
  const bool triangulate = false, default_colours = false;
  if (!tinyobj::LoadObj(&contents.attributes, &contents.shapes, &materials, &warnings, &errors, &in, nullptr,
                        triangulate, default_colours))
    throw FileError(path.string(), errors.empty() ? "cannot be read as OBJ" : first_line(errors));
  return contents;
}

void append_faces(const tinyobj::mesh_t& from, PolygonMesh& mesh) {
  for (const unsigned char size : from.num_face_vertices) mesh.face_sizes.push_back(size);
  for (const tinyobj::index_t& corner : from.indices)
    mesh.face_vertices.push_back(static_cast<Index>(corner.vertex_index));
}

/// Unless a corner goes without.
void append_corner_uv(const ObjContents& contents, PolygonMesh& mesh) {
  const std::vector<tinyobj::real_t>& uv = contents.attributes.texcoords;
  for (const tinyobj::shape_t& shape : contents.shapes)
    for (const tinyobj::index_t& corner : shape.mesh.indices) {
      if (corner.texcoord_index < 0) return mesh.corner_uv.clear();
      const auto at = 2 * static_cast<std::size_t>(corner.texcoord_index);
      mesh.corner_uv.emplace_back(uv[at], uv[at + 1]);
    }
}

/// Tags as OpenSubdiv's regression shapes have them: `crease 2/1/0 a b sharpness`, `corner 1/1/0 v
/// sharpness`, `interpolateboundary 1/0/0 rule`, vertices counted from 0. Other tags are not geometry.
class TagReader {
 public:
  TagReader(const std::filesystem::path& path, PolygonMesh& mesh) : path_(path.string()), mesh_(mesh) {}

  void read(const tinyobj::tag_t& tag) {
    if (tag.name == "crease") {
      check_arguments(tag, 2, 1);
      mesh_.creases.push_back({vertex(tag, 0), vertex(tag, 1), sharpness(tag)});
    } else if (tag.name == "corner") {
      check_arguments(tag, 1, 1);
      mesh_.corners.push_back({vertex(tag, 0), sharpness(tag)});
    } else if (tag.name == "interpolateboundary") {
      check_arguments(tag, 1, 0);
      mesh_.boundary = tag.intValues[0] == 1 ? BoundaryRule::edges_and_corners : BoundaryRule::edges_only;
    }
  }

 private:
  void check_arguments(const tinyobj::tag_t& tag, std::size_t integers, std::size_t reals) {
    if (tag.intValues.size() != integers || tag.floatValues.size() != reals)
      fail(tag, fmt::format("takes {} integers and {} real numbers", integers, reals));
  }

  Index vertex(const tinyobj::tag_t& tag, std::size_t argument) {
    const int index = tag.intValues[argument];
    if (index < 0 || static_cast<std::size_t>(index) >= mesh_.positions.size())
      fail(tag, fmt::format("names vertex {}, counted from 0, of {}", index, mesh_.positions.size()));
    return static_cast<Index>(index);
  }

  float sharpness(const tinyobj::tag_t& tag) {
    if (!(tag.floatValues[0] >= 0)) fail(tag, "has a negative sharpness");
    return tag.floatValues[0];
  }

  [[noreturn]] void fail(const tinyobj::tag_t& tag, const std::string& what) {
    throw FileError(path_, fmt::format("tag {}", tag.name), what);
  }

  std::string path_;
  PolygonMesh& mesh_;
};

}  // namespace

PolygonMesh read_obj(const std::filesystem::path& path) {
  check_obj_lines(path);
  const ObjContents contents = load(path);
  PolygonMesh mesh;
  const std::vector<tinyobj::real_t>& xyz = contents.attributes.vertices;
  for (std::size_t i = 0; i + 2 < xyz.size(); i += 3)
    mesh.positions.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
  for (const tinyobj::shape_t& shape : contents.shapes) append_faces(shape.mesh, mesh);
  append_corner_uv(contents, mesh);
  if (contents.shapes.empty()) return mesh;
  // Every shape repeats the tags of those before it.
  TagReader reader(path, mesh);
  for (const tinyobj::tag_t& tag : contents.shapes.back().mesh.tags) reader.read(tag);
  return mesh;
}

}  // namespace burin
