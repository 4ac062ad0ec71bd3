#include "support/mesh_fault.h"

#include <fmt/format.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <iterator>
#include <utility>
#include <vector>

namespace burin::test {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;

}  // namespace

std::string mesh_fault(const TriangleMesh& mesh) {
  std::vector<Kernel::Point_3> points;
  for (const Vec3f& p : mesh.positions)
    points.emplace_back(static_cast<double>(p.x()), static_cast<double>(p.y()), static_cast<double>(p.z()));
  std::vector<std::array<std::size_t, 3>> polygons;
  for (const Triangle& t : mesh.triangles) polygons.push_back({t[0], t[1], t[2]});
  if (!pmp::is_polygon_soup_a_polygon_mesh(polygons)) return "no polygon mesh";
  CgalMesh made;
  pmp::polygon_soup_to_polygon_mesh(points, polygons, made);
  if (!CGAL::is_closed(made)) return "open";
  if (!CGAL::is_valid_polygon_mesh(made)) return "not valid";
  std::vector<std::pair<CgalMesh::Face_index, CgalMesh::Face_index>> pairs;
  pmp::self_intersections(made, std::back_inserter(pairs));
  std::string text = pairs.empty() ? "" : "triangles intersect:";
  for (const auto& [first, second] : pairs) {
    const Kernel::Point_3& at = made.point(target(halfedge(first, made), made));
    text += fmt::format(" ({:.4f}, {:.4f}, {:.4f})", at.x(), at.y(), at.z());
  }
  return text;
}

}  // namespace burin::test
