// Writes a GLB file [Khronos, glTF 2.0] with one node, one mesh and one primitive.
#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/surface/files/mesh_formats.h>
#include <burin/surface/files/over_clay.h>
#include <burin/surface/files/smooth_normals.h>
#include <burin/surface/topology/weld.h>

#include <Eigen/Geometry>
#include <bit>
#include <nlohmann/json.hpp>
#include <string>

namespace burin {
namespace {

using OrderedJson = nlohmann::ordered_json;

void put(std::string& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(value >> shift & 0xff));
}

void put(std::string& bytes, float value) { put(bytes, std::bit_cast<std::uint32_t>(value)); }

/// The vertices that a file needs so that each has one pair of texture coordinates.
struct SplitVertices {
  std::vector<Index> source;  ///< [vertex of the file] vertex of the mesh
  std::vector<Vec2f> uv;      ///< [vertex of the file], or empty
  std::vector<Triangle> triangles;
};

SplitVertices split(const TriangleMesh& mesh) {
  SplitVertices vertices;
  vertices.triangles = mesh.triangles;
  if (mesh.triangle_uv.empty()) {
    for (Index i = 0; i < mesh.positions.size(); ++i) vertices.source.push_back(i);
    return vertices;
  }
  std::vector<Vec3f> places;  // the vertex, u, v
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vec2f& uv = mesh.triangle_uv[i][corner];
      places.emplace_back(std::bit_cast<float>(mesh.triangles[i][corner]), uv.x(), uv.y());
    }
  const std::vector<Index> first = first_at_position(places);
  std::vector<Index> number(first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] == i) {
      vertices.source.push_back(mesh.triangles[i / 3][i % 3]);
      vertices.uv.push_back(mesh.triangle_uv[i / 3][i % 3]);
      number[i] = static_cast<Index>(vertices.source.size() - 1);
    } else {
      number[i] = number[first[i]];
    }
    vertices.triangles[i / 3][i % 3] = number[i];
  }
  return vertices;
}

/// The one buffer of the file, and the JSON that describes it.
class Contents {
 public:
  OrderedJson json = {{"asset", {{"version", "2.0"}, {"generator", "Burin"}}},
                      {"scene", 0},
                      {"scenes", {{{"nodes", {0}}}}},
                      {"nodes", {{{"mesh", 0}}}},
                      {"meshes", OrderedJson::array()},
                      {"accessors", OrderedJson::array()},
                      {"bufferViews", OrderedJson::array()},
                      {"buffers", OrderedJson::array()}};
  std::string bytes;

  /// Adds an accessor over the bytes that `put_all` appends; returns its index.
  template <class PutAll>
  std::size_t add(const char* type, int component_type, std::size_t count, const PutAll& put_all) {
    constexpr int for_vertices = 34962, for_indices = 34963;
    const std::size_t begin = bytes.size(), number = json["accessors"].size();
    put_all();
    json["bufferViews"].push_back({{"buffer", 0},
                                   {"byteOffset", begin},
                                   {"byteLength", bytes.size() - begin},
                                   {"target", component_type == unsigned_int ? for_indices : for_vertices}});
    json["accessors"].push_back(
        {{"bufferView", number}, {"componentType", component_type}, {"count", count}, {"type", type}});
    return number;
  }

  static constexpr int unsigned_byte = 5121, unsigned_int = 5125, floating = 5126;
};

OrderedJson bounds(const Vec3f& corner) { return {corner.x(), corner.y(), corner.z()}; }

OrderedJson attributes(Contents& contents, const TriangleMesh& mesh, const VertexPaint& paint,
                       const SplitVertices& vertices) {
  const std::size_t count = vertices.source.size();
  OrderedJson attributes;
  const auto add = [&](const char* name, const char* type, const auto& put_one) {
    attributes[name] = contents.add(type, Contents::floating, count, [&] {
      for (std::size_t i = 0; i < count; ++i) put_one(i);
    });
  };
  Eigen::AlignedBox3f box;
  add("POSITION", "VEC3", [&](std::size_t i) {
    const Vec3f& position = mesh.positions[vertices.source[i]];
    box.extend(position);
    for (const float coordinate : position) put(contents.bytes, coordinate);
  });
  OrderedJson& positions = contents.json["accessors"].back();
  positions["min"] = bounds(box.min());
  positions["max"] = bounds(box.max());
  const std::vector<Vec3f> normals = smooth_normals(mesh);
  add("NORMAL", "VEC3", [&](std::size_t i) {
    for (const float coordinate : normals[vertices.source[i]]) put(contents.bytes, coordinate);
  });
  if (!vertices.uv.empty())
    add("TEXCOORD_0", "VEC2", [&](std::size_t i) {
      put(contents.bytes, vertices.uv[i].x());
      put(contents.bytes, 1 - vertices.uv[i].y());
    });
  if (!paint.colours.empty())
    add("COLOR_0", "VEC4", [&](std::size_t i) {
      for (const float channel : over_clay(paint.colours[vertices.source[i]])) put(contents.bytes, channel);
      put(contents.bytes, 1.0F);  // assimp 5.2 takes three numbers for a colour that cannot be seen
    });
  if (shows_clay(paint.colours)) {
    attributes["_INK"] = contents.add("VEC4", Contents::unsigned_byte, count, [&] {
      for (const Index source : vertices.source)
        for (const std::uint8_t channel : paint.colours[source])
          contents.bytes.push_back(static_cast<char>(channel));
    });
    contents.json["accessors"].back()["normalized"] = true;
  }
  if (!paint.masks.empty())
    add("_MASK", "SCALAR", [&](std::size_t i) { put(contents.bytes, paint.masks[vertices.source[i]]); });
  return attributes;
}

/// Writes a chunk with its header, padded to a multiple of four bytes.
void write_chunk(std::ostream& out, std::uint32_t type, std::string bytes, char filling) {
  bytes.resize((bytes.size() + 3) / 4 * 4, filling);
  std::string head;
  put(head, static_cast<std::uint32_t>(bytes.size()));
  put(head, type);
  out << head << bytes;
}

}  // namespace

void write_glb(const std::filesystem::path& path, const TriangleMesh& mesh, const VertexPaint& paint,
               const Vec3d& origin) {
  constexpr std::uint32_t magic = 0x46546c67, json_chunk = 0x4e4f534a, binary_chunk = 0x004e4942;
  constexpr std::size_t most_bytes = 0xffffff00;
  const SplitVertices vertices = split(mesh);
  Contents contents;
  OrderedJson primitive = {{"attributes", attributes(contents, mesh, paint, vertices)}};
  primitive["indices"] = contents.add("SCALAR", Contents::unsigned_int, 3 * vertices.triangles.size(), [&] {
    for (const Triangle& triangle : vertices.triangles)
      for (const Index vertex : triangle) put(contents.bytes, vertex);
  });
  contents.json["meshes"].push_back({{"primitives", OrderedJson::array({primitive})}});
  contents.json["buffers"].push_back({{"byteLength", contents.bytes.size()}});
  if (!origin.isZero(0)) contents.json["nodes"][0]["translation"] = {origin.x(), origin.y(), origin.z()};
  const std::string text = contents.json.dump();
  const std::size_t size = 12 + 8 + (text.size() + 3) / 4 * 4 + 8 + contents.bytes.size();
  if (size > most_bytes) throw FileError(path.string(), "GLB files hold no more than 4 GB");
  write_file_whole(path, [&](std::ostream& out) {
    std::string head;
    for (const std::uint32_t number : {magic, 2U, static_cast<std::uint32_t>(size)}) put(head, number);
    out << head;
    write_chunk(out, json_chunk, text, ' ');
    write_chunk(out, binary_chunk, std::move(contents.bytes), '\0');
  });
}

}  // namespace burin
