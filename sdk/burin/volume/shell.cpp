// Finds the prisms over the triangles of a chart, in which a point in space has stroke coordinates [S.
// Porumbescu et al., Shell Maps, 2005]. Newton's method finds the foot of a point: its barycentric
// coordinates and height in the prism.
#include <burin/base/parallel.h>
#include <burin/chart/chart_triangles.h>
#include <burin/volume/shell.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {
namespace {

/// By which weights may be below 0 so that no point between two prisms is in neither.
constexpr double rounding = 1e-6;

/// The same at the chart's rim: about one triangle beyond it.
constexpr double beyond_rim = 1, beside_rim = 0.5;

/// Below this cosine between the directions of the stroke at two corners their coordinates are those of
/// different legs of it, or of a bend no wider than the triangle.
constexpr double least_agreement = 0.9;

double determinant(const Eigen::Matrix3d& m) { return m.col(0).cross(m.col(1)).dot(m.col(2)); }

/// The sides of a chart's triangles.
class Sides {
 public:
  explicit Sides(std::span<const ChartTriangle> triangles) {
    sides_.reserve(3 * triangles.size());
    for (const ChartTriangle& triangle : triangles)
      for (std::size_t i = 0; i < 3; ++i) sides_.push_back(side(triangle, i));
    parallel_sort(sides_.begin(), sides_.end());
  }

  /// Whether the side opposite a corner has no other triangle beyond it.
  bool is_rim(const ChartTriangle& triangle, std::size_t opposite) const {
    return std::ranges::equal_range(sides_, side(triangle, opposite)).size() == 1;
  }

 private:
  using Side = std::pair<Index, Index>;

  static Side side(const ChartTriangle& triangle, std::size_t opposite) {
    return std::minmax({triangle.nodes[(opposite + 1) % 3], triangle.nodes[(opposite + 2) % 3]});
  }

  std::vector<Side> sides_;
};

}  // namespace

Prism::Prism(const std::array<Corner, 3>& corners, const std::array<Index, 3>& nodes,
             const std::array<bool, 3>& rim)
    : corners_(corners),
      nodes_(nodes),
      rim_(rim),
      edge_a_(corners[1].position - corners[0].position),
      edge_b_(corners[2].position - corners[0].position),
      normal_a_(corners[1].normal - corners[0].normal),
      normal_b_(corners[2].normal - corners[0].normal),
      up_(edge_a_.cross(edge_b_).normalized()),
      size_(std::sqrt(std::max(edge_a_.squaredNorm(), edge_b_.squaredNorm()))) {
  const bool any = rim[0] || rim[1] || rim[2];
  for (std::size_t i = 0; i < 3; ++i) least_weight_[i] = rim[i] ? -beyond_rim : any ? -beside_rim : -rounding;
  parted_ = is_parted();
  (corners_[0].normal + corners_[1].normal + corners_[2].normal).cwiseAbs().maxCoeff(&axis_);
}

/// Whether the corners belong to different legs of a bend: their directions differ, and what the distance of
/// one goes on to is more than the other has, which is the least of both legs'. Around the outside of a bend
/// it is less.
bool Prism::is_parted() const {
  bool differ = false;
  double excess = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner& from = corners_[i];
    for (std::size_t j = 0; j < 3; ++j) {
      const Corner& to = corners_[j];
      differ = differ || from.e1.dot(to.e1) < least_agreement;
      const double told = static_cast<double>(from.d) + from.along_d.dot(to.position - from.position);
      excess += std::abs(told) - std::abs(static_cast<double>(to.d));
    }
  }
  return differ && excess > 0;
}

Vec3d Prism::position(double a, double b, double h) const {
  return corners_[0].position + a * edge_a_ + b * edge_b_ +
         h * (corners_[0].normal + a * normal_a_ + b * normal_b_);
}

Eigen::Matrix3d Prism::jacobian(double a, double b, double h) const {
  Eigen::Matrix3d columns;
  columns << edge_a_ + h * normal_a_, edge_b_ + h * normal_b_,
      corners_[0].normal + a * normal_a_ + b * normal_b_;
  return columns;
}

bool Prism::upright() const {
  const Vec3d area = edge_a_.cross(edge_b_);
  return std::ranges::all_of(corners_, [&](const Corner& corner) { return area.dot(corner.normal) > 0; });
}

/// Within the triangle, or beyond one of its edges at the rim: also a little beside it, since there may be no
/// triangle at all around the edge's ends.
bool Prism::within(double a, double b) const {
  const std::array<double, 3> weights{1 - a - b, a, b};
  const double least = std::ranges::min(weights);
  if (least >= -rounding) return true;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!rim_[i] || weights[i] >= 0 || weights[i] < -beyond_rim) continue;
    if (std::min(weights[(i + 1) % 3], weights[(i + 2) % 3]) >= -beside_rim) return true;
  }
  return false;
}

/// Whether the prism turns inside out between the triangle and this height: its volume is a quadratic in the
/// height, whose least value counts.
bool Prism::folded(double a, double b, double h) const {
  const double at_0 = determinant(jacobian(a, b, 0)), half = determinant(jacobian(a, b, h / 2)),
               whole = determinant(jacobian(a, b, h));
  const double square = 2 * (at_0 + whole - 2 * half), linear = 4 * half - 3 * at_0 - whole;
  double least = std::min(at_0, whole);
  if (square > 0 && linear < 0 && -linear < 2 * square)
    least = std::min(least, at_0 - linear * linear / (4 * square));
  return !(least > 0);
}

std::optional<Prism::Foot> Prism::foot_of(const Vec3d& p) const {
  constexpr int most_steps = 12;
  constexpr double close = 1e-9, farthest = 100;
  double a = 1. / 3, b = 1. / 3, h = (p - corners_[0].position).dot(up_);
  for (int step = 0;; ++step) {
    const Vec3d miss = p - position(a, b, h);
    if (miss.squaredNorm() <= close * close * size_ * size_) break;
    const Eigen::Matrix3d columns = jacobian(a, b, h);
    const double whole = determinant(columns);
    if (step == most_steps || !(std::abs(whole) > 0)) return {};
    a += miss.cross(columns.col(1)).dot(columns.col(2)) / whole;
    b += columns.col(0).cross(miss).dot(columns.col(2)) / whole;
    h += columns.col(0).cross(columns.col(1)).dot(miss) / whole;
    if (!(std::abs(a) < farthest && std::abs(b) < farthest)) return {};
  }
  if (!within(a, b) || folded(a, b, h)) return {};
  const double height = h * (corners_[0].normal + a * normal_a_ + b * normal_b_).norm();
  return Foot{a, b, height, position(a, b, 0)};
}

/// The mean of the line between the corners' values and of those that their gradients go on to is right to
/// second order, since their errors are opposite.
Vec2d Prism::coordinates_at(double a, double b, const Vec3d& foot) const {
  const std::array<double, 3> weights{1 - a - b, a, b};
  double t = 0, d = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d way = foot - corners_[i].position;
    t += weights[i] * (corners_[i].t + corners_[i].along_t.dot(way) / 2);
    d += weights[i] * (static_cast<double>(corners_[i].d) + corners_[i].along_d.dot(way) / 2);
  }
  return {t, d};
}

ShellPoint Prism::between(const Foot& foot) const {
  const Vec2d coordinates = coordinates_at(foot.a, foot.b, foot.position);
  ShellPoint point;
  point.t = coordinates.x();
  point.d = static_cast<float>(coordinates.y());
  point.h = static_cast<float>(foot.h);
  point.nodes = nodes_;
  point.weights = Vec3d(1 - foot.a - foot.b, foot.a, foot.b).cast<float>();
  return point;
}

Vec3d Prism::point(double a, double b, double height) const {
  const Vec3d normal = corners_[0].normal + a * normal_a_ + b * normal_b_;
  return position(a, b, height / normal.norm());
}

ShellPoint Prism::from_corner(const Foot& foot, std::size_t corner) const {
  const Corner& from = corners_[corner];
  const Vec3d way = foot.position - from.position;
  ShellPoint point;
  point.t = from.t + from.along_t.dot(way);
  point.d = static_cast<float>(static_cast<double>(from.d) + from.along_d.dot(way));
  point.h = static_cast<float>(foot.h);
  point.nodes = nodes_;
  point.weights[static_cast<Eigen::Index>(corner)] = 1;
  return point;
}

/// The corners, at this height, of the triangle that the least weights bound.
std::array<Vec3d, 3> Prism::edge_at(double h) const {
  const double a0 = least_weight_[1], b0 = least_weight_[2], c0 = least_weight_[0];
  return {position(a0, b0, h), position(1 - b0 - c0, b0, h), position(a0, 1 - a0 - c0, h)};
}

Eigen::AlignedBox3d Prism::box(double h_min, double h_max) const {
  Eigen::AlignedBox3d box;
  for (const double h : {h_min, h_max})
    for (const Vec3d& corner : edge_at(h)) box.extend(corner);
  return box;
}

/// Along each of the three edges that run outward the coordinate changes evenly with the height. Only heights
/// count at which an edge, and so the prism, can be between the bounds.
Eigen::AlignedBox3d Prism::layer(double h_min, double h_max, double low, double high) const {
  const std::array<Vec3d, 3> bottom = edge_at(h_min), top = edge_at(h_max);
  double least = 1, most = 0;  // shares of the way from the bottom to the top
  for (std::size_t i = 0; i < 3; ++i) {
    const double from = bottom[i][axis_], way = top[i][axis_] - from;
    // An edge that does not run along the axis may be anywhere.
    if (!(std::abs(way) > 0)) return box(h_min, h_max);
    const auto [first, last] = std::minmax({(low - from) / way, (high - from) / way});
    least = std::min(least, first);
    most = std::max(most, last);
  }
  least = std::max(least, 0.);
  most = std::min(most, 1.);
  if (!(least <= most)) return {};
  const double height = h_max - h_min;
  return box(h_min + least * height, h_min + most * height);
}

std::vector<Prism> shell_over(const SolidGround& ground) {
  const Chart& chart = ground.chart;
  const std::vector<ChartTriangle> triangles = chart_triangles(ground.surface, chart);
  const Sides sides(triangles);
  std::vector<Prism> prisms;
  prisms.reserve(triangles.size());
  for (const ChartTriangle& triangle : triangles) {
    std::array<Prism::Corner, 3> corners;
    std::array<bool, 3> rim{};
    // Around round ends (t, d) are normal coordinates, which the surface stretches only by its curvature.
    const bool beyond =
        !chart.closed && std::ranges::any_of(triangle.t, [&](double t) { return t < 0 || t > chart.length; });
    for (std::size_t i = 0; i < 3; ++i) {
      const Index node = triangle.nodes[i];
      const Vec3d normal = chart.normal[node].cast<double>(), e1 = chart.e1[node].cast<double>();
      corners[i] = {.position = ground.position(chart.vertex[node]).cast<double>(),
                    .normal = normal,
                    .t = triangle.t[i],
                    .d = chart.d[node],
                    .along_t = e1 / (beyond ? 1 : static_cast<double>(chart.stretch[node])),
                    .along_d = normal.cross(e1),
                    .e1 = e1};
      rim[i] = sides.is_rim(triangle, i);
    }
    const Prism prism(corners, triangle.nodes, rim);
    if (prism.upright()) prisms.push_back(prism);
  }
  return prisms;
}

}  // namespace burin
