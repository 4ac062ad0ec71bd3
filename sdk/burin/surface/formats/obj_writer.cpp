// Writes OBJ files: vertices with their colours, each distinct pair of texture coordinates once, and
// triangles. Coordinates have the fewest digits that read back as the same bits.
#include <burin/base/file.h>
#include <burin/surface/files/mesh_formats.h>
#include <burin/surface/files/over_clay.h>
#include <burin/surface/topology/weld.h>
#include <fmt/format.h>

#include <iterator>

namespace burin {
namespace {

/// Appends a position, with the fewest digits that read back as the same bits.
void put_vertex(std::string& line, const Vec3f& position, const Vec3d& origin) {
  line += 'v';
  for (int axis = 0; axis < 3; ++axis) {
    if (origin.isZero(0)) {
      fmt::format_to(std::back_inserter(line), " {}", position[axis]);
    } else {
      fmt::format_to(std::back_inserter(line), " {}", position[axis] + origin[axis]);
    }
  }
}

void put_colour(std::string& line, const PaintBytes& colour) {
  const PaintBytes shown = bytes_over_clay(colour);
  for (std::size_t i = 0; i < 3; ++i)
    fmt::format_to(std::back_inserter(line), " {}", static_cast<float>(shown[i]) / 255);
}

/// Writes each distinct pair of texture coordinates once. Returns its index, from 1, for each corner.
std::vector<Index> write_texture(std::ostream& out, const TriangleMesh& mesh) {
  std::vector<Vec3f> places;
  for (const auto& corners : mesh.triangle_uv)
    for (const Vec2f& uv : corners) places.emplace_back(uv.x(), uv.y(), 0);
  std::vector<Index> number = first_at_position(places);
  Index count = 0;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] < i) {
      number[i] = number[number[i]];
      continue;
    }
    number[i] = ++count;
    out << fmt::format("vt {} {}\n", places[i].x(), places[i].y());
  }
  return number;
}

}  // namespace

void write_obj(const std::filesystem::path& path, const TriangleMesh& mesh, const VertexPaint& paint,
               const Vec3d& origin) {
  write_file_whole(path, [&](std::ostream& out) {
    std::string line;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      line.clear();
      put_vertex(line, mesh.positions[i], origin);
      if (!paint.colours.empty()) put_colour(line, paint.colours[i]);
      out << line << '\n';
    }
    const std::vector<Index> texture = write_texture(out, mesh);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      line = 'f';
      for (std::size_t corner = 0; corner < 3; ++corner) {
        fmt::format_to(std::back_inserter(line), " {}", mesh.triangles[i][corner] + 1);
        if (!texture.empty()) fmt::format_to(std::back_inserter(line), "/{}", texture[3 * i + corner]);
      }
      out << line << '\n';
    }
  });
}

}  // namespace burin
