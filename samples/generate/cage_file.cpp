// Writes a cage as an OBJ file.
#include "cage_file.h"

#include <burin/base/file.h>
#include <fmt/format.h>

#include <cstddef>
#include <ostream>

namespace burin::samples {

namespace {

void write_faces(std::ostream& out, const PolygonMesh& cage) {
  std::size_t corner = 0;
  for (const Index size : cage.face_sizes) {
    out << 'f';
    for (const std::size_t end = corner + size; corner < end; ++corner)
      out << fmt::format(" {}", cage.face_vertices[corner] + 1);
    out << '\n';
  }
}

}  // namespace

void write_cage(const std::filesystem::path& path, std::string_view title, const PolygonMesh& cage) {
  write_file_whole(path, [&](std::ostream& out) {
    out << fmt::format("# {}\n# {} vertices, {} faces\n", title, cage.positions.size(),
                       cage.face_sizes.size());
    for (const Vec3f& p : cage.positions) out << fmt::format("v {:.4f} {:.4f} {:.4f}\n", p.x(), p.y(), p.z());
    write_faces(out, cage);
    // An OBJ tag starts with the counts of its values: here two integers (vertices, from 0) and one real
    // (sharpness).
    for (const CreaseEdge& edge : cage.creases)
      out << fmt::format("t crease 2/1/0 {} {} {:.1f}\n", edge.a, edge.b, edge.sharpness);
  });
}

}  // namespace burin::samples
