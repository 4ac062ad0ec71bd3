// Measures the surroundings of a vertex on the edges to its neighbours, in O(valence): the size of its cell,
// and the mean curvature by a least-squares fit of the shape operator.
#include <burin/surface/topology/surroundings.h>

#include <Eigen/Cholesky>
#include <cmath>

namespace burin {

float cell_size(const Surface& surface, Index vertex, const Vec3f& tangent) {
  const auto neighbours = surface.neighbours[vertex];
  if (neighbours.empty()) return 0;
  float squares = 0;
  for (const Index neighbour : neighbours) {
    const float along = (surface.positions[neighbour] - surface.positions[vertex]).dot(tangent);
    squares += along * along;
  }
  // In a square grid of edge h the squared components of the edges along any direction have the mean h^2 / 2.
  return std::sqrt(2 * squares / static_cast<float>(neighbours.size()));
}

float mean_curvature(const Surface& surface, Index vertex) {
  const Vec3f& normal = surface.normals[vertex];
  const Vec3f e1 = normal.unitOrthogonal(), e2 = normal.cross(e1);
  // The unknowns are the entries a, b, c of the symmetric map [a b; b c]; each neighbour gives two equations.
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Vec3d right = Vec3d::Zero();
  double scale = 0;
  for (const Index neighbour : surface.neighbours[vertex]) {
    const Vec3f step = surface.positions[neighbour] - surface.positions[vertex];
    const Vec3f turn = surface.normals[neighbour] - normal;
    const double u = step.dot(e1), v = step.dot(e2);
    const Vec3d rows[] = {{u, v, 0}, {0, u, v}};
    const double turns[] = {turn.dot(e1), turn.dot(e2)};
    for (int k = 0; k < 2; ++k) {
      squares += rows[k] * rows[k].transpose();
      right += turns[k] * rows[k];
    }
    scale += u * u + v * v;
  }
  const Eigen::LDLT<Eigen::Matrix3d> solver(squares);
  constexpr double smallest_share = 1e-9;
  if (!(scale > 0) || !(solver.vectorD().minCoeff() > smallest_share * scale)) return 0;
  const Vec3d shape = solver.solve(right);
  return static_cast<float>((shape[0] + shape[2]) / 2);
}

}  // namespace burin
