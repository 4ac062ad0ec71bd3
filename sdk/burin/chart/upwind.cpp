// Second order. In Fermi coordinates (t, d) along the stroke, with k the geodesic curvature of the lines of
// constant d, J the stretch of t and K the Gauss curvature, a step of the vector (u, v) from q to x changes
//   k by K v + k^2 v,  J by -J (k v + K v^2 / 2),  the angle of e1 by k u,  t by u / J,  d by v
// per unit of length. k and J come first, from q alone; they vary along t as well, which q cannot know, so
// the mean over the arms is taken where the line through their values over u has u = 0. Then e1, t and d are
// integrated by the trapezoidal rule between the frames of q and x, which needs no derivative of k or J.
#include <burin/chart/frame_step.h>
#include <burin/chart/upwind.h>
#include <burin/surface/unit_tangent.h>

#include <algorithm>
#include <cmath>

namespace burin {

/// Four arms. Lanes that hold none repeat the first, and do not count.
struct UpwindArms::Four {
  Lanes3 normal, e1;  ///< at q
  Lanes3 chord;       ///< from q to x
  Lanes t, d, curvature, stretch;
  Lanes gauss;  ///< along the edge
  Lanes on;     ///< 1, or 0 for what does not count

  Lanes length;    ///< |x - q|, object units
  Lanes u, v;      ///< the step from q to x in the basis (e1, e2) of q
  Lanes3 carried;  ///< e1 of q transported to x

  void walk(const Vec3f& normal_x);

  /// Where the first order places x.
  Lanes placed_t() const { return t + u; }
  Lanes placed_d() const { return d + v; }

  /// An arm along the geodesic from the stroke knows most of x; what it has to add for its way u along the
  /// stroke is what is uncertain.
  Lanes weight(float epsilon) const {
    constexpr float sideways = 0.3F;
    return on / (u * u + sideways * (length + epsilon).square());
  }

  /// k and J at x as q alone knows them.
  Lanes stretch_at_end() const { return stretch * (1 - curvature * v - gauss * v * v / 2); }
  Lanes curvature_at_end() const { return curvature / (1 - curvature * v) + gauss * v; }
};

namespace {

using Lanes = Eigen::Array4f;

/// Beyond this turn along one step a focal point is near too, radians.
constexpr float largest_turn = 0.5F;

template <class A, class B>
Lanes dot(const A& a, const B& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// cos and sin of small angles, off by less than angle^5 / 240.
struct Rotation {
  explicit Rotation(const Lanes& angle) {
    const Lanes half = angle / 2 * (1 + angle * angle / 12), squared = half * half;
    const Lanes inverse = (1 + squared).inverse();
    cosine = (1 - squared) * inverse;
    sine = 2 * half * inverse;
  }
  Lanes cosine, sine;
};

}  // namespace

UpwindArms::UpwindArms() = default;
UpwindArms::~UpwindArms() = default;

/// step_along_edge() in lanes. With unit normals the two rotations over the plane half way are one, and the
/// cosines follow from the length of the normals' sum.
void UpwindArms::Four::walk(const Vec3f& n) {
  const Lanes3 sum{normal.x + n.x(), normal.y + n.y(), normal.z + n.z()};
  const Lanes squared_sum = dot(sum, sum), size = squared_sum.sqrt(), inverse_size = size.inverse();
  const Lanes3 middle{sum.x * inverse_size, sum.y * inverse_size, sum.z * inverse_size};

  const Lanes along = e1.x * n.x() + e1.y * n.y() + e1.z * n.z();
  const Lanes whole = 2 * along / squared_sum;
  carried = {e1.x - whole * sum.x, e1.y - whole * sum.y, e1.z - whole * sum.z};
  const Lanes half = along * inverse_size / (1 + size / 2);
  const Lanes3 e{e1.x - half * (normal.x + middle.x), e1.y - half * (normal.y + middle.y),
                 e1.z - half * (normal.z + middle.z)};
  const Lanes3 left{middle.y * e.z - middle.z * e.y, middle.z * e.x - middle.x * e.z,
                    middle.x * e.y - middle.y * e.x};

  const Lanes ahead = dot(chord, e), beside = dot(chord, left);
  const Lanes squared_length = dot(chord, chord), flat = ahead * ahead + beside * beside;
  const Lanes3 turn{n.x() - normal.x, n.y() - normal.y, n.z() - normal.z};
  const Lanes scale = (squared_length / flat).sqrt();
  const Lanes bend = dot(turn, chord) / (24 * dot(turn, turn).max(1));
  length = squared_length.sqrt();
  u = ahead * scale + bend * dot(turn, e);
  v = beside * scale + bend * dot(turn, left);

  // Opposite normals, and edges along the normal or too short for their squares.
  constexpr float opposite = 0.002F;
  if (squared_sum.minCoeff() > opposite && flat.minCoeff() > std::numeric_limits<float>::min()) return;
  for (int i = 0; i < 4; ++i) {
    const Vec3f edge(chord.x[i], chord.y[i], chord.z[i]);
    const FrameStep step = step_along_edge(Vec3f::Zero(), Vec3f(normal.x[i], normal.y[i], normal.z[i]),
                                           Vec3f(e1.x[i], e1.y[i], e1.z[i]), edge, n);
    u[i] = step.step.x();
    v[i] = step.step.y();
    length[i] = edge.norm();
    carried.x[i] = step.e1.x();
    carried.y[i] = step.e1.y();
    carried.z[i] = step.e1.z();
  }
}

UpwindArms::Four UpwindArms::load(std::size_t first) const {
  const std::size_t count = std::min<std::size_t>(arms_.size() - first, 4);
  const Arm &a = arms_[first], &b = arms_[first + (count > 1 ? 1 : 0)],
            &c = arms_[first + (count > 2 ? 2 : 0)], &e = arms_[first + (count > 3 ? 3 : 0)];
  const FrontNode &p = *a.from, &q = *b.from, &r = *c.from, &s = *e.from;
  const auto lanes = [&](const auto& of) { return Lanes(of(p), of(q), of(r), of(s)); };
  const auto lanes3 = [&](const auto& of) {
    return Lanes3{Lanes(of(p).x(), of(q).x(), of(r).x(), of(s).x()),
                  Lanes(of(p).y(), of(q).y(), of(r).y(), of(s).y()),
                  Lanes(of(p).z(), of(q).z(), of(r).z(), of(s).z())};
  };
  const auto relative = [this](const Arm& arm) { return static_cast<float>(arm.t - origin_); };
  Four four;
  four.normal = lanes3([](const FrontNode& n) -> const Vec3f& { return n.normal; });
  four.e1 = lanes3([](const FrontNode& n) -> const Vec3f& { return n.frame.e1; });
  four.chord = lanes3([](const FrontNode& n) -> const Vec3f& { return n.position; });
  const Vec3f& x = x_->position;
  four.chord = {x.x() - four.chord.x, x.y() - four.chord.y, x.z() - four.chord.z};
  four.t = Lanes(relative(a), relative(b), relative(c), relative(e));
  four.d = lanes([](const FrontNode& n) { return n.frame.d; });
  four.curvature = lanes([](const FrontNode& n) { return n.frame.curvature; });
  four.stretch = lanes([](const FrontNode& n) { return n.frame.stretch; });
  four.gauss = (lanes([](const FrontNode& n) { return n.gauss; }) + x_->gauss) / 2;
  four.on = Lanes(1, count > 1 ? 1 : 0, count > 2 ? 1 : 0, count > 3 ? 1 : 0);
  return four;
}

void UpwindArms::walk_edges() {
  origin_ = arms_[0].t;
  fours_.clear();
  for (std::size_t first = 0; first < arms_.size(); first += 4) {
    fours_.push_back(load(first));
    fours_.back().walk(x_->normal);
  }
  if (!all_agree()) keep_agreeing();
}

/// Whether all arms place x so close together that any two agree.
bool UpwindArms::all_agree() const {
  const Four& first = fours_[0];
  Lanes t_low = first.placed_t(), t_high = t_low, d_low = first.placed_d(), d_high = d_low,
        shortest = first.length;
  for (std::size_t i = 1; i < fours_.size(); ++i) {
    const Lanes t = fours_[i].placed_t(), d = fours_[i].placed_d();
    t_low = t_low.min(t);
    t_high = t_high.max(t);
    d_low = d_low.min(d);
    d_high = d_high.max(d);
    shortest = shortest.min(fours_[i].length);
  }
  const float t = t_high.maxCoeff() - t_low.minCoeff(), d = d_high.maxCoeff() - d_low.minCoeff();
  const float reach = 4 * shortest.minCoeff();
  return t * t + d * d <= reach * reach;
}

void UpwindArms::keep_agreeing() {
  const auto lane = [this](std::size_t i) {
    return std::pair<Four&, int>(fours_[i / 4], static_cast<int>(i % 4));
  };
  std::size_t nearest = 0;
  const auto distance = [&](std::size_t i) {
    const auto& [four, l] = lane(i);
    return std::abs(four.placed_d()[l]);
  };
  for (std::size_t i = 1; i < arms_.size(); ++i)
    if (distance(i) < distance(nearest)) nearest = i;
  const auto [with, n] = lane(nearest);
  for (std::size_t i = 0; i < arms_.size(); ++i) {
    const auto& [four, l] = lane(i);
    const float reach = 2 * (four.length[l] + with.length[n]);
    const float t = four.placed_t()[l] - with.placed_t()[n], d = four.placed_d()[l] - with.placed_d()[n];
    if (t * t + d * d <= reach * reach) continue;
    four.on[l] = four.curvature[l] = four.gauss[l] = 0;
    four.stretch[l] = 1;
  }
}

bool UpwindArms::near_focal_point() const {
  return std::ranges::any_of(fours_, [](const Four& four) {
    const Lanes turn = four.curvature.square() * (four.u.square() + four.v.square());
    return turn.maxCoeff() > largest_turn * largest_turn || four.stretch_at_end().minCoeff() < least_stretch;
  });
}

/// Weighted least squares of the shapes over the arms' u, at u = 0. The slope is damped in proportion to how
/// little the arms spread over u.
UpwindArms::Shape UpwindArms::shape_at_zero() const {
  constexpr float damping = 0.03F;
  Lanes weights = Lanes::Zero(), u = weights, uu = weights, vv = weights, k = weights, j = weights,
        ku = weights, ju = weights;
  for (const Four& four : fours_) {
    const Lanes w = four.weight(epsilon_), wu = w * four.u;
    const Lanes curvature = four.curvature_at_end(), stretch = four.stretch_at_end();
    weights += w;
    u += wu;
    uu += wu * four.u;
    vv += w * four.v.square();
    k += w * curvature;
    j += w * stretch;
    ku += wu * curvature;
    ju += wu * stretch;
  }
  const float inverse = 1 / weights.sum(), u_mean = u.sum() * inverse, uu_mean = uu.sum() * inverse;
  const float spread = uu_mean - u_mean * u_mean + damping * (uu_mean + vv.sum() * inverse);
  const float lever = spread > 0 ? u_mean / spread : 0;
  const auto corrected = [&](float sum, float products) {
    const float value = sum * inverse;
    return value - (products * inverse - u_mean * value) * lever;
  };
  return {corrected(k.sum(), ku.sum()), std::max(corrected(j.sum(), ju.sum()), least_stretch)};
}

/// The mean of k and J over the arms, near focal points.
UpwindArms::Shape UpwindArms::mean_shape() const {
  Lanes weights = Lanes::Zero(), k = weights, j = weights;
  for (const Four& four : fours_) {
    const Lanes w = four.weight(epsilon_);
    weights += w;
    k += w * four.curvature;
    j += w * four.stretch;
  }
  return {k.sum() / weights.sum(), j.sum() / weights.sum()};
}

Vec3f UpwindArms::turned_mean(float curvature) const {
  Lanes3 ahead{Lanes::Zero(), Lanes::Zero(), Lanes::Zero()}, beside = ahead;
  for (const Four& four : fours_) {
    const Rotation turn((four.curvature + curvature) / 2 * four.u);
    const Lanes w = four.weight(epsilon_), cosine = w * turn.cosine, sine = w * turn.sine;
    ahead.x += cosine * four.carried.x;
    ahead.y += cosine * four.carried.y;
    ahead.z += cosine * four.carried.z;
    beside.x += sine * four.carried.x;
    beside.y += sine * four.carried.y;
    beside.z += sine * four.carried.z;
  }
  const Vec3f e1(ahead.x.sum(), ahead.y.sum(), ahead.z.sum());
  const Vec3f e2 = x_->normal.cross(Vec3f(beside.x.sum(), beside.y.sum(), beside.z.sum()));
  return unit_tangent(e1 + e2, x_->normal);
}

ChartFrame UpwindArms::weighted_mean() const {
  Lanes weights = Lanes::Zero(), t = weights, d = weights;
  Lanes3 e1{weights, weights, weights};
  for (const Four& four : fours_) {
    const Lanes w = four.on / (four.length + epsilon_);
    weights += w;
    t += w * four.placed_t();
    d += w * four.placed_d();
    e1.x += w * four.carried.x;
    e1.y += w * four.carried.y;
    e1.z += w * four.carried.z;
  }
  const float inverse = 1 / weights.sum();
  ChartFrame frame;
  frame.t = origin_ + static_cast<double>(t.sum() * inverse);
  frame.d = d.sum() * inverse;
  frame.e1 = unit_tangent(Vec3f(e1.x.sum(), e1.y.sum(), e1.z.sum()), x_->normal);
  return frame;
}

ChartFrame UpwindArms::first_order() {
  walk_edges();
  return weighted_mean();
}

ChartFrame UpwindArms::second_order() {
  walk_edges();
  if (near_focal_point()) {
    ChartFrame frame = weighted_mean();
    const Shape shape = mean_shape();
    frame.curvature = shape.curvature;
    frame.stretch = shape.stretch;
    return frame;
  }
  ChartFrame frame;
  const Shape shape = shape_at_zero();
  frame.curvature = shape.curvature;
  frame.stretch = shape.stretch;
  frame.e1 = turned_mean(frame.curvature);

  const Vec3f &e1 = frame.e1, right = e1.cross(x_->normal);
  Lanes weights = Lanes::Zero(), t = weights, d = weights;
  for (const Four& four : fours_) {
    // The arm's step in the basis of the frame at x.
    const Lanes3& c = four.carried;
    const Lanes cosine = c.x * e1.x() + c.y * e1.y() + c.z * e1.z();
    const Lanes sine = c.x * right.x() + c.y * right.y() + c.z * right.z();
    const Lanes u = four.u * cosine + four.v * sine, v = four.v * cosine - four.u * sine;
    const Lanes w = four.weight(epsilon_);
    weights += w;
    t += w * (four.t + (four.u / four.stretch + u / frame.stretch) / 2);
    d += w * (four.d + (four.v + v) / 2);
  }
  const float inverse = 1 / weights.sum();
  frame.t = origin_ + static_cast<double>(t.sum() * inverse);
  frame.d = d.sum() * inverse;
  return frame;
}

}  // namespace burin
