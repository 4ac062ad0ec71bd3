// Builds the cage of the ewer: a surface of revolution with a lip, closed by grids of quads and joined to a
// handle.
#include <burin/math/elementary.h>

#include "ewer_cage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace burin::samples {

namespace {

using std::numbers::pi;

constexpr int segments = 20;  // number around the axis; the caps need a multiple of 4
constexpr int handle_segment = segments / 2;
constexpr int cap_side = segments / 4;  // quads along one side of a cap's grid

struct ProfileRing {
  double radius, height;
  float crease;
};

// The rings run from the underside of the foot along the outside to the bottom of the mouth's hollow.
constexpr std::array profile{
    ProfileRing{.270, -.970, 0}, ProfileRing{.370, -1.00, 3}, ProfileRing{.240, -.850, 0},
    ProfileRing{.400, -.720, 0}, ProfileRing{.555, -.575, 0}, ProfileRing{.665, -.410, 0},
    ProfileRing{.725, -.235, 0}, ProfileRing{.735, -.055, 0}, ProfileRing{.700, .120, 0},
    ProfileRing{.620, .275, 0},  ProfileRing{.500, .405, 0},  ProfileRing{.360, .500, 0},
    ProfileRing{.245, .610, 2},  ProfileRing{.215, .770, 0},  ProfileRing{.235, .910, 0},
    ProfileRing{.310, 1.02, 0},  ProfileRing{.385, 1.08, 3},  ProfileRing{.240, 1.00, 0},
    ProfileRing{.150, .880, 0},
};
constexpr int rings = static_cast<int>(profile.size());
constexpr int first_neck_ring = 13;
constexpr int upper_root_ring = 14, lower_root_ring = 9;

struct HandleRing {
  double x, y;              // centre, in the plane z = 0
  double tangent;           // angle of the direction of travel in that plane, degrees
  double thickness, width;  // half, in the plane and across it
};
constexpr std::array handle{
    HandleRing{-.38, .985, 165, .070, .085}, HandleRing{-.56, 1.00, 190, .062, .085},
    HandleRing{-.75, .930, 220, .060, .090}, HandleRing{-.88, .760, 252, .060, .092},
    HandleRing{-.90, .560, 280, .064, .098}, HandleRing{-.80, .385, 315, .085, .120},
};

Vec3f on_circle(double radius, double angle, double height) {
  return Vec3d(radius * math::cos(angle), height, -radius * math::sin(angle)).cast<float>();
}

/// The weight of the lip at an angle from its middle.
double bell(double angle, double width) { return math::exp(-angle * angle / (width * width)); }

Vec3f profile_position(int ring, int segment) {
  const double angle = 2 * pi * segment / segments;
  const double from_lip = std::min(angle, 2 * pi - angle);
  auto [radius, height, crease] = profile[static_cast<std::size_t>(ring)];
  if (ring >= first_neck_ring) {
    const double rise = math::pow(std::clamp((height - .75) / (1.08 - .75), 0., 1.), 2);
    radius += rise * (.20 * bell(from_lip, .42) - .045 * bell(from_lip - .95, .35));
    height += rise * .07 * bell(from_lip, .5);
  }
  return on_circle(radius, angle, height);
}

/// Maps the square [-1, 1]^2 to the unit disc so that concentric squares become circles [Shirley and Chiu
/// 1997]. Returns radius and angle; the radius may be negative.
std::pair<double, double> concentric_disc(double u, double v) {
  if (u == 0 && v == 0) return {0, 0};
  if (std::abs(u) > std::abs(v)) return {u, pi / 4 * v / u};
  return {v, pi / 2 - pi / 4 * u / v};
}

class CageBuilder {
 public:
  PolygonMesh build() {
    add_profile();
    add_cap(0, profile.front().height + .02, false);
    add_cap(rings - 1, profile.back().height - .02, true);
    add_handle();
    drop_unused_vertices();
    round_positions();
    return std::move(cage_);
  }

 private:
  using Loop = std::array<Index, 8>;

  static Index ring_vertex(int ring, int segment) {
    return static_cast<Index>(ring * segments + (segment + segments) % segments);
  }

  void add_quad(Index a, Index b, Index c, Index d) {
    cage_.face_sizes.push_back(4);
    cage_.face_vertices.insert(cage_.face_vertices.end(), {a, b, c, d});
  }

  Index add_vertex(const Vec3f& position) {
    cage_.positions.push_back(position);
    return static_cast<Index>(cage_.positions.size() - 1);
  }

  /// Whether a root of the handle replaces this face: it replaces the 2 x 2 faces around its middle.
  static bool under_handle(int ring, int segment) {
    const bool across = segment == handle_segment - 1 || segment == handle_segment;
    const auto along = [ring](int root) { return ring == root - 1 || ring == root; };
    return across && (along(upper_root_ring) || along(lower_root_ring));
  }

  void add_profile() {
    for (int ring = 0; ring < rings; ++ring)
      for (int segment = 0; segment < segments; ++segment) add_vertex(profile_position(ring, segment));
    for (int ring = 0; ring < rings; ++ring)
      for (int segment = 0; segment < segments; ++segment) {
        const float crease = profile[static_cast<std::size_t>(ring)].crease;
        const Index a = ring_vertex(ring, segment), b = ring_vertex(ring, segment + 1);
        if (crease > 0) cage_.creases.push_back({a, b, crease});
        if (ring + 1 < rings && !under_handle(ring, segment))
          add_quad(a, b, ring_vertex(ring + 1, segment + 1), ring_vertex(ring + 1, segment));
      }
  }

  /// The number of the ring's segment at a boundary vertex of the cap's grid.
  static int boundary_segment(int a, int b) {
    if (b == 0) return a;
    if (a == cap_side) return cap_side + b;
    if (b == cap_side) return 3 * cap_side - a;
    return segments - b;
  }

  Index cap_vertex(int ring, double height, int a, int b) {
    if (a == 0 || b == 0 || a == cap_side || b == cap_side) return ring_vertex(ring, boundary_segment(a, b));
    const auto [radius, angle] = concentric_disc(2. * a / cap_side - 1, 2. * b / cap_side - 1);
    // The corner (0, 0), at 225 degrees of the disc, is segment 0.
    return add_vertex(
        on_circle(radius * profile[static_cast<std::size_t>(ring)].radius, angle - 1.25 * pi, height));
  }

  /// Closes a ring by a grid of quads.
  void add_cap(int ring, double height, bool upwards) {
    std::array<std::array<Index, cap_side + 1>, cap_side + 1> grid{};
    for (int a = 0; a <= cap_side; ++a)
      for (int b = 0; b <= cap_side; ++b)
        grid[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] = cap_vertex(ring, height, a, b);
    for (std::size_t a = 0; a < cap_side; ++a)
      for (std::size_t b = 0; b < cap_side; ++b) {
        if (upwards)
          add_quad(grid[a][b], grid[a + 1][b], grid[a + 1][b + 1], grid[a][b + 1]);
        else
          add_quad(grid[a][b], grid[a][b + 1], grid[a + 1][b + 1], grid[a + 1][b]);
      }
  }

  // The border of a square of 3 x 3 vertices, as offsets (up or outwards, along the segments).
  static constexpr std::array<std::pair<int, int>, 8> around{
      {{-1, -1}, {-1, 0}, {-1, 1}, {0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}}};

  static Loop root_loop(int ring, int up) {
    Loop loop{};
    for (std::size_t i = 0; i < loop.size(); ++i)
      loop[i] = ring_vertex(ring + up * around[i].first, handle_segment + around[i].second);
    return loop;
  }

  Loop handle_loop(const HandleRing& ring) {
    const double angle = ring.tangent * pi / 180;
    const Vec3d outwards(math::sin(angle), -math::cos(angle), 0);
    Loop loop{};
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const double length =
          math::hypot(static_cast<double>(around[i].first), static_cast<double>(around[i].second));
      const Vec3d offset =
          around[i].first * ring.thickness * outwards + around[i].second * ring.width * Vec3d::UnitZ();
      loop[i] = add_vertex((Vec3d(ring.x, ring.y, 0) + offset / length).cast<float>());
    }
    return loop;
  }

  void bridge(const Loop& from, const Loop& to) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      const std::size_t next = (i + 1) % from.size();
      add_quad(from[i], from[next], to[next], to[i]);
    }
  }

  /// Adds the handle, an arch from the neck down to the shoulder, where its outer side is the lower one.
  void add_handle() {
    Loop last = root_loop(upper_root_ring, 1);
    for (const HandleRing& ring : handle) {
      const Loop loop = handle_loop(ring);
      bridge(last, loop);
      last = loop;
    }
    bridge(last, root_loop(lower_root_ring, -1));
  }

  /// Removes the vertices in the middles of the handle's roots.
  void drop_unused_vertices() {
    std::vector<Index> place(cage_.positions.size(), no_index);
    for (const Index vertex : cage_.face_vertices) place[vertex] = 0;
    Index used = 0;
    for (std::size_t i = 0; i < place.size(); ++i) {
      if (place[i] == no_index) continue;
      cage_.positions[used] = cage_.positions[i];
      place[i] = used++;
    }
    cage_.positions.resize(used);
    for (Index& vertex : cage_.face_vertices) vertex = place[vertex];
    for (CreaseEdge& crease : cage_.creases) crease = {place[crease.a], place[crease.b], crease.sharpness};
  }

  /// Rounds to the decimals of the file, so that the cage and its file are equal.
  void round_positions() {
    for (Vec3f& position : cage_.positions)
      position = (position.cast<double>() * 1e4).array().round().matrix().cast<float>() / 1e4f;
  }

  PolygonMesh cage_;
};

}  // namespace

PolygonMesh ewer_cage() { return CageBuilder().build(); }

}  // namespace burin::samples
