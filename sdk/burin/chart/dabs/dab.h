#pragma once
#include <burin/base/vector.h>
#include <burin/chart/chart_ground.h>
#include <burin/surface/surface.h>
#include <burin/surface/surface_point.h>

#include <memory>
#include <vector>

namespace burin {

/// How normal coordinates spread from the centre p. A step from q to its neighbour x is added to the
/// coordinates of q after it was turned into the basis of p; the methods differ in that turn, which is to
/// say in the frame that they put at q, and in how many neighbours have a say. Where curvature varies little
/// within the radius all are alike, the first two a little better: on a sphere their frames are exact.
enum class DabMethod {
  /// The discrete exponential map [Schmidt, Grimm and Wyvill 2006]: the one neighbour on the shortest path
  /// of the edge graph; the frame at q is that of p turned by the minimal rotation between their normals,
  /// whatever lies between. Passes around a horn and collapses it; wrong on cones.
  dem,
  /// The same frames, the mean over all upwind neighbours [Schmidt 2010]: no tears from one path to the next.
  dem_upwind,
  /// Frames propagated from neighbour to neighbour and averaged like the coordinates [Schmidt 2013, section
  /// 3]: right on developable surfaces, cones included. Wraps around a horn and tears behind it.
  frame_propagation,
};

struct DabOptions {
  double radius = 0;  ///< object units, > 0
  DabMethod method = DabMethod::frame_propagation;
};

/// Normal coordinates (an approximation of the log map) of the region around a point, structure of arrays.
/// The centre has (0, 0) and the frame (e1, e2 = n x e1, n); u runs along e1 and v along e2.
struct DabChart {
  std::vector<Index> vertex;  ///< of the surface, ascending
  std::vector<float> u, v;    ///< object units, u^2 + v^2 <= radius^2
  std::vector<Vec3f> e1;      ///< the frame that the method puts at the vertex; unit, tangent
  std::vector<Vec3f> normal;  ///< unit, of the ground that the dab lies on

  std::size_t size() const { return vertex.size(); }
};

/// Computes dabs on one surface, or over the nodes of a base surface as its vertices. Holds scratch memory of
/// four bytes a vertex, so keep one as long as the surface; a dab costs in proportion to its own region only.
/// The surface must outlive it. One thread at a time.
class DabChartBuilder {
 public:
  explicit DabChartBuilder(const Surface& surface) : DabChartBuilder(ChartGround(surface)) {}
  explicit DabChartBuilder(const ChartGround& ground);
  ~DabChartBuilder();
  DabChartBuilder(DabChartBuilder&&) noexcept;
  DabChartBuilder& operator=(DabChartBuilder&&) noexcept;

  /// The region around `centre`, of which no vertex lies farther away than twice the radius along edges.
  /// `e1`: direction of u, turned into the tangent plane of the centre; any length. The result is a function
  /// of surface and arguments. Throws ContractError for a radius that is not finite and positive, a direction
  /// that is not finite or zero, a centre that is not on the surface.
  DabChart chart(const SurfacePoint& centre, const Vec3f& e1, const DabOptions& options);

  /// The same with the unit normal at the centre, where interpolation would not find it: a point of a base
  /// surface lies beside the node that is its corner.
  DabChart chart(const SurfacePoint& centre, const Vec3f& normal, const Vec3f& e1, const DabOptions& options);

 private:
  void check(const SurfacePoint& centre, const Vec3f& e1, const DabOptions& options) const;

  struct Dab;
  std::unique_ptr<Dab> dab_;
};

}  // namespace burin
