#pragma once
#include <burin/base/vector.h>
#include <burin/chart/chart_ground.h>
#include <burin/surface/surface.h>
#include <burin/surface/surface_point.h>

#include <memory>
#include <vector>

namespace burin {

/// How normal coordinates spread from the centre p. The edge from a vertex q to its neighbour x is rotated
/// into the basis of p and added to the coordinates of q. The methods differ in the frame at q, which defines
/// this rotation, and in which neighbours q contribute. Where curvature varies little within the radius their
/// results are similar; the first two are slightly better, since on a sphere their frames are exact.
enum class DabMethod {
  /// The discrete exponential map [Schmidt, Grimm and Wyvill 2006]. Only the neighbour on the shortest path
  /// of the edge graph contributes; its frame is that of p after the minimal rotation between the two
  /// normals, whatever lies between. It passes around a horn and collapses it, and is wrong on cones.
  dem,
  /// The frames of `dem`, with the mean over all upwind neighbours [Schmidt 2010]: coordinates do not tear
  /// between neighbouring paths.
  dem_upwind,
  /// Frames are propagated from neighbour to neighbour and averaged like the coordinates [Schmidt 2013,
  /// section 3]. Correct on developable surfaces, cones included. It wraps around a horn and tears behind it.
  frame_propagation,
};

struct DabOptions {
  double radius = 0;  ///< object units, > 0
  DabMethod method = DabMethod::frame_propagation;
};

/// Normal coordinates (an approximation of the logarithmic map) of the region around a point, as a structure
/// of arrays. The centre has the coordinates (0, 0) and the frame (e1, e2 = n x e1, n); u runs along e1 and v
/// along e2.
struct DabChart {
  std::vector<Index> vertex;  ///< vertex of the surface, ascending
  std::vector<float> u, v;    ///< object units, u^2 + v^2 <= radius^2
  std::vector<Vec3f> e1;      ///< first axis of the method's frame at the vertex; unit, tangent
  std::vector<Vec3f> normal;  ///< unit normal of the surface or base surface that the dab lies on

  std::size_t size() const { return vertex.size(); }
};

/// Computes dabs on one surface, or on the nodes of a base surface taken for vertices. Holds four bytes of
/// scratch memory per vertex, so keep one object as long as the surface. A dab costs O(n log n) for the n
/// vertices of its region. The surface must outlive the object. One thread at a time.
class DabChartBuilder {
 public:
  explicit DabChartBuilder(const Surface& surface) : DabChartBuilder(ChartGround(surface)) {}
  explicit DabChartBuilder(const ChartGround& ground);
  ~DabChartBuilder();
  DabChartBuilder(DabChartBuilder&&) noexcept;
  DabChartBuilder& operator=(DabChartBuilder&&) noexcept;

  /// Computes the dab around `centre`. Vertices farther away than twice the radius along edges are left out.
  /// `e1` is the direction of u, of any length; it is projected to the tangent plane of the centre. The
  /// result is a function of surface and arguments. Throws ContractError for a radius that is not finite and
  /// positive, a direction that is not finite or is zero, and a centre that is not on the surface.
  DabChart chart(const SurfacePoint& centre, const Vec3f& e1, const DabOptions& options);

  /// Computes the dab around `centre` with a given unit normal at the centre. On a base surface the normal
  /// cannot be interpolated: a point lies beside the only node that is its corner.
  DabChart chart(const SurfacePoint& centre, const Vec3f& normal, const Vec3f& e1, const DabOptions& options);

 private:
  void check(const SurfacePoint& centre, const Vec3f& e1, const DabOptions& options) const;

  struct Dab;
  std::unique_ptr<Dab> dab_;
};

}  // namespace burin
