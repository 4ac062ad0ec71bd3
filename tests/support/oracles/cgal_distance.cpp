#include "cgal_distance.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

namespace burin::test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Paths = CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;

Mesh cgal_mesh(const Surface& surface, const Region& region) {
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> triangles;
  for (const Index vertex : region.vertices) {
    const Vec3d x = surface.positions[vertex].cast<double>();
    points.emplace_back(x.x(), x.y(), x.z());
  }
  for (const auto& [a, b, c] : region.corners) triangles.push_back({a, b, c});
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  return mesh;
}

}  // namespace

// The source is the middle of the triangle, so the order of the triangle's corners does not matter.
std::vector<double> cgal_distances(const Surface& surface, const Region& region, Index local_triangle) {
  const Mesh mesh = cgal_mesh(surface, region);
  Paths paths(mesh);
  paths.add_source_point(Mesh::Face_index(local_triangle), {1. / 3, 1. / 3, 1. / 3});
  paths.build_sequence_tree();
  std::vector<double> distances;
  for (const Mesh::Vertex_index vertex : mesh.vertices())
    distances.push_back(paths.shortest_distance_to_source_points(vertex).first);
  return distances;
}

}  // namespace burin::test
