// Second order. In Fermi coordinates (t, d) along the stroke, with k the geodesic curvature of the lines of
// constant d, J the stretch of t and K the Gauss curvature, a step of the vector (u, v) from q to x changes
//   k by K v + k^2 v,  J by -J (k v + K v^2 / 2),  the angle of e1 by k u,  t by u / J,  d by v
// per unit of length. k and J come first, from q alone; they vary along t as well, which q cannot know, so
// the mean over the arms is taken where the line through their values over u has u = 0. Then e1, t and d are
// integrated by the trapezoidal rule between the frames of q and x, which needs no derivative of k or J.
#include <burin/chart/upwind.h>
#include <burin/surface/unit_tangent.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace burin {
namespace {

/// Beyond this turn along one step a focal point is near too, radians.
constexpr float largest_turn = 0.5F;

float weight(const UpwindArm& arm, float epsilon) { return 1 / (arm.length + epsilon); }

/// Second order: an arm along the geodesic from the stroke knows most of x; what it has to add for its way u
/// along the stroke is what is uncertain.
float geodesic_weight(const UpwindArm& arm, float epsilon) {
  constexpr float sideways = 0.3F;
  const float u = arm.edge.step.x(), length = arm.length + epsilon;
  return 1 / (u * u + sideways * length * length);
}

/// Where the first order places x.
double placed_t(const UpwindArm& arm) { return arm.frame.t + static_cast<double>(arm.edge.step.x()); }
float placed_d(const UpwindArm& arm) { return arm.frame.d + arm.edge.step.y(); }

bool agree(const UpwindArm& a, const UpwindArm& b) {
  const double reach = 2 * static_cast<double>(a.length + b.length);
  const double t = placed_t(a) - placed_t(b), d = static_cast<double>(placed_d(a) - placed_d(b));
  return t * t + d * d <= reach * reach;
}

/// k and J at x as q alone knows them.
struct Shape {
  float curvature, stretch;
};

Shape shape_at_end(const UpwindArm& arm) {
  const float k = arm.frame.curvature, v = arm.edge.step.y();
  return {k / (1 - k * v) + arm.gauss * v, arm.frame.stretch * (1 - k * v - arm.gauss * v * v / 2)};
}

bool near_focal_point(const UpwindArm& arm) {
  return std::abs(arm.frame.curvature) * arm.edge.step.norm() > largest_turn ||
         shape_at_end(arm).stretch < least_stretch;
}

/// Weighted least squares of the shapes over the arms' u, at u = 0. The slope is damped in proportion to how
/// little the arms spread over u.
Shape shape_at_zero(std::span<const UpwindArm> arms, float epsilon) {
  constexpr float damping = 0.03F;
  float weights = 0, u_mean = 0, uu = 0, all = 0;
  Shape mean{0, 0}, product{0, 0};
  for (const UpwindArm& arm : arms) {
    const float w = geodesic_weight(arm, epsilon), u = arm.edge.step.x();
    const Shape shape = shape_at_end(arm);
    weights += w;
    u_mean += w * u;
    uu += w * u * u;
    all += w * arm.edge.step.squaredNorm();
    mean.curvature += w * shape.curvature;
    mean.stretch += w * shape.stretch;
    product.curvature += w * u * shape.curvature;
    product.stretch += w * u * shape.stretch;
  }
  u_mean /= weights;
  const float spread = uu / weights - u_mean * u_mean + damping * all / weights;
  const float lever = spread > 0 ? u_mean / spread : 0;
  const auto corrected = [&](float sum, float products) {
    const float value = sum / weights;
    return value - (products / weights - u_mean * value) * lever;
  };
  return {corrected(mean.curvature, product.curvature),
          std::max(corrected(mean.stretch, product.stretch), least_stretch)};
}

/// The mean of `shape` over the arms, near focal points.
Shape mean_shape(std::span<const UpwindArm> arms, float epsilon) {
  float weights = 0;
  Shape mean{0, 0};
  for (const UpwindArm& arm : arms) {
    const float w = geodesic_weight(arm, epsilon);
    weights += w;
    mean.curvature += w * arm.frame.curvature;
    mean.stretch += w * arm.frame.stretch;
  }
  return {mean.curvature / weights, mean.stretch / weights};
}

Vec3f turned_mean(std::span<const UpwindArm> arms, const Vec3f& normal, float curvature, float epsilon) {
  Vec3f sum = Vec3f::Zero();
  for (const UpwindArm& arm : arms) {
    const float angle = (arm.frame.curvature + curvature) / 2 * arm.edge.step.x();
    sum += geodesic_weight(arm, epsilon) *
           (std::cos(angle) * arm.edge.e1 + std::sin(angle) * normal.cross(arm.edge.e1));
  }
  return unit_tangent(sum, normal);
}

/// The arm's step in the basis of a frame at x.
Vec2f step_in(const Vec3f& e1, const Vec3f& normal, const FrameStep& edge) {
  const float cosine = edge.e1.dot(e1), sine = normal.cross(edge.e1).dot(e1);
  return {edge.step.x() * cosine + edge.step.y() * sine, edge.step.y() * cosine - edge.step.x() * sine};
}

}  // namespace

void keep_agreeing(std::vector<UpwindArm>& arms) {
  const UpwindArm nearest = *std::ranges::min_element(arms, {}, [](const UpwindArm& arm) {
    return std::tuple(std::abs(placed_d(arm)), arm.from, arm.frame.t);
  });
  std::erase_if(arms, [&](const UpwindArm& arm) { return !agree(arm, nearest); });
}

ChartFrame first_order_frame(std::span<const UpwindArm> arms, const Vec3f& normal, float epsilon) {
  // t is summed relative to one arm's, for floats of full accuracy.
  const double origin = arms[0].frame.t;
  float weights = 0, t = 0, d = 0;
  Vec3f e1 = Vec3f::Zero();
  for (const UpwindArm& arm : arms) {
    const float w = weight(arm, epsilon);
    weights += w;
    t += w * static_cast<float>(placed_t(arm) - origin);
    d += w * placed_d(arm);
    e1 += w * arm.edge.e1;
  }
  ChartFrame frame;
  frame.t = origin + static_cast<double>(t / weights);
  frame.d = d / weights;
  frame.e1 = unit_tangent(e1, normal);
  return frame;
}

ChartFrame second_order_frame(std::span<const UpwindArm> arms, const Vec3f& normal, float epsilon) {
  if (std::ranges::any_of(arms, near_focal_point)) {
    ChartFrame frame = first_order_frame(arms, normal, epsilon);
    const Shape shape = mean_shape(arms, epsilon);
    frame.curvature = shape.curvature;
    frame.stretch = shape.stretch;
    return frame;
  }
  ChartFrame frame;
  const Shape shape = shape_at_zero(arms, epsilon);
  frame.curvature = shape.curvature;
  frame.stretch = shape.stretch;
  frame.e1 = turned_mean(arms, normal, frame.curvature, epsilon);

  const double origin = arms[0].frame.t;
  float weights = 0, t = 0, d = 0;
  for (const UpwindArm& arm : arms) {
    const float w = geodesic_weight(arm, epsilon);
    const Vec2f begin = arm.edge.step, end = step_in(frame.e1, normal, arm.edge);
    weights += w;
    t += w * (static_cast<float>(arm.frame.t - origin) +
              (begin.x() / arm.frame.stretch + end.x() / frame.stretch) / 2);
    d += w * (arm.frame.d + (begin.y() + end.y()) / 2);
  }
  frame.t = origin + static_cast<double>(t / weights);
  frame.d = d / weights;
  return frame;
}

}  // namespace burin
