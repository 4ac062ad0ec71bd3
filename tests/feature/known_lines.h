#pragma once
#include <burin/base/vector.h>
#include <burin/feature/snap.h>
#include <burin/surface/picker.h>
#include <burin/surface/surface.h>
#include <burin/surface/triangle_mesh.h>

#include <functional>
#include <random>
#include <vector>

namespace burin::test {

/// A mesh with a feature in a known place. Its edges are about 1 long.
struct KnownLine {
  TriangleMesh mesh;
  std::function<Vec3d(double s)> line;                ///< a point of it, s in [0, 1]
  std::function<Vec3d(double s, double off)> beside;  ///< a point of the surface, `off` to the line's left
  std::function<double(const Vec3d&)> distance;       ///< of a point of the surface from the line
};

/// A Gaussian bump of width `w` (standard deviation) and height `h` along an arc of radius `bend` in a plane.
KnownLine ridge_in_plane(double w, double h, double bend, double reach, double length, std::uint32_t seed);

/// The same along a circle of latitude on a sphere, `polar` from the pole, in radians.
KnownLine ridge_on_sphere(double w, double h, double sphere_radius, double polar, double reach, double length,
                          std::uint32_t seed);

/// The same along the line y = 0 of the saddle z = (x^2 - y^2) / (2 size).
KnownLine ridge_on_saddle(double w, double h, double size, double reach, double length, std::uint32_t seed);

/// Moves the vertices along their normals by normally distributed amounts.
void add_noise(TriangleMesh& mesh, double deviation, std::uint32_t seed);

/// A surface with what strokes on it need.
struct SnapScene {
  explicit SnapScene(TriangleMesh mesh);
  SnapResult snap(const std::vector<Vec3d>& pen, const Feature& feature, const SnapOptions& options);
  /// The same for a pen that ends where it starts, as a closed stroke.
  SnapResult snap_closed(const std::vector<Vec3d>& pen, const Feature& feature, const SnapOptions& options);

  Surface surface;
  Picker picker;
  StrokeSnapper snapper;
  SurfaceCurve stroke;  ///< the last one
};

/// Distances of the points of the snapped ranges from a line, ascending.
std::vector<double> distances(const SnapResult& result, const std::function<double(const Vec3d&)>& distance);

double quantile(const std::vector<double>& ascending, double share);

}  // namespace burin::test
