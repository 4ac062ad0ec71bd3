#include <burin/base/error.h>
#include <burin/base/file.h>
#include <burin/surface/mesh_file.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <string>

namespace burin {
namespace {

constexpr std::size_t elements_a_chunk = 65536;

void put_little_endian(std::string& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(value >> shift & 0xff));
}

void put(std::string& bytes, float value) { put_little_endian(bytes, std::bit_cast<std::uint32_t>(value)); }

/// With what is painted on it.
void put_vertex(std::string& bytes, const TriangleMesh& mesh, const VertexPaint& paint, std::size_t vertex) {
  for (const float coordinate : mesh.positions[vertex]) put(bytes, coordinate);
  if (!paint.colours.empty())
    for (const std::uint8_t channel : paint.colours[vertex]) bytes.push_back(static_cast<char>(channel));
  if (!paint.masks.empty()) put(bytes, paint.masks[vertex]);
}

void put(std::string& bytes, const Triangle& triangle) {
  bytes.push_back(3);
  for (const Index vertex : triangle) put_little_endian(bytes, vertex);
}

/// Chunk by chunk: neither a call of the stream for every number nor the whole file in memory.
template <class Put>
void write_elements(std::ostream& out, std::size_t count, const Put& put_element) {
  std::string bytes;
  for (std::size_t begin = 0; begin < count; begin += elements_a_chunk) {
    bytes.clear();
    for (std::size_t i = begin; i < std::min(begin + elements_a_chunk, count); ++i) put_element(bytes, i);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
}

std::string paint_properties(const VertexPaint& paint) {
  std::string properties;
  if (!paint.colours.empty())
    for (const char* channel : {"red", "green", "blue", "alpha"})
      properties += fmt::format("property uchar {}\n", channel);
  if (!paint.masks.empty()) properties += "property float mask\n";
  return properties;
}

}  // namespace

void write_ply(const std::filesystem::path& path, const TriangleMesh& mesh, const VertexPaint& paint) {
  const auto one_each = [&](const auto& values) {
    return values.empty() || values.size() == mesh.positions.size();
  };
  if (!one_each(paint.colours) || !one_each(paint.masks))
    throw ContractError("write_ply: not one colour or mask a vertex");
  write_file_whole(path, [&](std::ostream& out) {
    out << fmt::format(
        "ply\nformat binary_little_endian 1.0\n"
        "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n{}"
        "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        mesh.positions.size(), paint_properties(paint), mesh.triangles.size());
    const auto put_painted = [&](std::string& bytes, std::size_t i) { put_vertex(bytes, mesh, paint, i); };
    const auto put_face = [&](std::string& bytes, std::size_t i) { put(bytes, mesh.triangles[i]); };
    write_elements(out, mesh.positions.size(), put_painted);
    write_elements(out, mesh.triangles.size(), put_face);
  });
}

}  // namespace burin
