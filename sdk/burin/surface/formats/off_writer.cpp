// Writes text files in Geomview's OFF format, with vertex colours as they appear over clay.
#include <burin/base/file.h>
#include <burin/surface/files/mesh_formats.h>
#include <burin/surface/files/over_clay.h>
#include <fmt/format.h>

#include <iterator>

namespace burin {

void write_off(const std::filesystem::path& path, const TriangleMesh& mesh, const VertexPaint& paint,
               const Vec3d& origin) {
  write_file_whole(path, [&](std::ostream& out) {
    const bool coloured = !paint.colours.empty();
    out << fmt::format("{}OFF\n{} {} 0\n", coloured ? "C" : "", mesh.positions.size(), mesh.triangles.size());
    const bool far = !origin.isZero(0);
    std::string line;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      line.clear();
      for (int axis = 0; axis < 3; ++axis) {
        const float coordinate = mesh.positions[i][axis];
        // fmt writes the fewest digits that read back as the same bits.
        far ? fmt::format_to(std::back_inserter(line), "{} ", coordinate + origin[axis])
            : fmt::format_to(std::back_inserter(line), "{} ", coordinate);
      }
      if (coloured)
        for (const std::uint8_t channel : bytes_over_clay(paint.colours[i]))
          fmt::format_to(std::back_inserter(line), "{} ", channel);
      line.back() = '\n';
      out << line;
    }
    for (const auto& [a, b, c] : mesh.triangles) out << fmt::format("3 {} {} {}\n", a, b, c);
  });
}

}  // namespace burin
