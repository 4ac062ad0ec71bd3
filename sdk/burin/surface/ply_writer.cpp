#include <burin/base/file.h>
#include <burin/surface/mesh_file.h>
#include <fmt/format.h>

#include <bit>
#include <span>
#include <string>

namespace burin {
namespace {

constexpr std::size_t elements_a_chunk = 65536;

void put_little_endian(std::string& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(value >> shift & 0xff));
}

void put(std::string& bytes, const Vec3f& position) {
  for (const float coordinate : position) put_little_endian(bytes, std::bit_cast<std::uint32_t>(coordinate));
}

void put(std::string& bytes, const Triangle& triangle) {
  bytes.push_back(3);
  for (const Index vertex : triangle) put_little_endian(bytes, vertex);
}

/// Chunk by chunk: neither a call of the stream for every number nor the whole file in memory.
template <class Element>
void write_elements(std::ostream& out, std::span<const Element> elements) {
  std::string bytes;
  for (std::size_t begin = 0; begin < elements.size(); begin += elements_a_chunk) {
    bytes.clear();
    for (const Element& element :
         elements.subspan(begin, std::min(elements_a_chunk, elements.size() - begin)))
      put(bytes, element);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
}

}  // namespace

void write_ply(const std::filesystem::path& path, const TriangleMesh& mesh) {
  write_file_whole(path, [&](std::ostream& out) {
    out << fmt::format(
        "ply\nformat binary_little_endian 1.0\n"
        "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
        "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        mesh.positions.size(), mesh.triangles.size());
    write_elements<Vec3f>(out, mesh.positions);
    write_elements<Triangle>(out, mesh.triangles);
  });
}

}  // namespace burin
