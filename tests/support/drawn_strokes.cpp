#include "support/drawn_strokes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "support/shapes.h"

namespace burin::test {
namespace {

constexpr double pi = std::numbers::pi;

/// A uniform random number, the same on every platform.
double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.);
}

double either_sign(std::mt19937& random) { return random() % 2 == 0 ? -1 : 1; }

/// A simulated pen that draws step by step; lengths are in units of the radius.
class Hand {
 public:
  explicit Hand(std::mt19937& random)
      : random_(&random),
        step_(uniform(random, 0.03, 0.15)),
        noise_(random() % 2 == 0 ? 0 : 0.003),
        heading_(uniform(random, 0, 2 * pi)) {
    at_ = Vec2d(uniform(random, -1, 1), uniform(random, -1, 1));
    put();
  }

  double random(double low, double high) { return uniform(*random_, low, high); }
  double sign() { return either_sign(*random_); }

  void arc(double length, double curvature) {
    const int steps = std::max(1, static_cast<int>(std::lround(length / step_)));
    for (int i = 0; i < steps; ++i) {
      const double way = length / steps;
      heading_ += way * curvature / 2;
      at_ += way * Vec2d(std::cos(heading_), std::sin(heading_));
      heading_ += way * curvature / 2;
      put();
    }
  }
  void line(double length) { arc(length, 0); }
  void turn(double angle) { heading_ += angle; }

  /// Draws gentle bends with radii above 2.
  void swing(double length) {
    const double bend = random(-0.5, 0.5);
    arc(length / 2, bend);
    arc(length / 2, random(-0.5, 0.5) - bend / 2);
  }

  void rest(int samples, double tremble) {
    const Vec2d place = at_;
    for (int i = 0; i < samples; ++i) {
      at_ = place + tremble * Vec2d(random(-1, 1), random(-1, 1));
      put();
    }
  }

  /// Goes back over the last samples; `share` is their share of all.
  void retrace(double share) {
    const auto back = static_cast<std::size_t>(share * static_cast<double>(way_.size() - 1));
    const std::size_t last = way_.size() - 1;
    for (std::size_t i = 1; i <= back; ++i) way_.push_back(way_[last - i]);
    at_ = way_.back();
    heading_ += pi;
  }

  /// The samples up to the point where they leave the square.
  std::vector<Vec2d> way() const {
    std::vector<Vec2d> inside;
    for (const Vec2d& sample : way_) {
      if (sample.cwiseAbs().maxCoeff() > 3) break;
      inside.push_back(sample);
    }
    return inside;
  }

 private:
  void put() { way_.emplace_back(at_ + noise_ * Vec2d(random(-1, 1), random(-1, 1))); }

  std::mt19937* random_;
  double step_, noise_, heading_;
  Vec2d at_;
  std::vector<Vec2d> way_;
};

void spiral(Hand& hand) {
  const double pitch = hand.random(0.3, 1.2), way = hand.sign();
  double radius = hand.random(0.1, 0.4);
  for (int i = 0; i < 24 && radius < 2; ++i) {
    hand.arc(radius * pi / 6, way / radius);
    radius += pitch / 12;
  }
}

void scrub(Hand& hand) {
  const double length = hand.random(0.8, 2.5), apart = hand.random(0.05, 0.5);
  double way = hand.sign();
  for (int i = 0; i < 6; ++i) {
    hand.line(length);
    hand.arc(pi * apart / 2, way * 2 / apart);
    way = -way;
  }
}

void scribble(Hand& hand) {
  for (int i = 0; i < 14; ++i) {
    hand.arc(hand.random(0.2, 0.9), hand.random(-4, 4));
    if (hand.random(0, 1) < 0.2) hand.turn(hand.random(-pi, pi));
  }
}

using Draw = void (*)(Hand& hand);
constexpr std::array<std::pair<std::string_view, Draw>, 13> kinds{{
    {"gentle", [](Hand& hand) { hand.swing(hand.random(1, 4)); }},
    {"hook at the begin",
     [](Hand& hand) {
       hand.line(hand.random(0.03, 0.5));
       hand.turn(hand.sign() * hand.random(0.4, 1) * pi);
       hand.swing(3);
     }},
    {"hook at the end",
     [](Hand& hand) {
       hand.swing(3);
       hand.turn(hand.sign() * hand.random(0.4, 1) * pi);
       hand.line(hand.random(0.03, 0.5));
     }},
    {"corners",
     [](Hand& hand) {
       for (int i = 0; i < 3; ++i) {
         hand.line(hand.random(0.3, 1.6));
         hand.turn(hand.sign() * hand.random(0.2, 0.95) * pi);
       }
       hand.line(1);
     }},
    {"cusp",
     [](Hand& hand) {
       const double way = hand.sign(), bend = hand.random(0.2, 1.5);
       hand.arc(1.5, way * bend);
       hand.turn(pi);
       hand.arc(1.5, way * bend);
     }},
    {"retraced",
     [](Hand& hand) {
       hand.swing(hand.random(1, 3));
       hand.retrace(hand.random(0.3, 1));
     }},
    {"scrubbing", scrub},
    {"rest",
     [](Hand& hand) {
       hand.swing(hand.random(0.2, 2));
       hand.rest(20, hand.random(0.003, 0.06));
       hand.swing(hand.random(0.2, 2));
     }},
    {"small loop",
     [](Hand& hand) {
       const double radius = hand.random(0.12, 0.9), way = hand.sign();
       hand.line(hand.random(0.2, 1.5));
       hand.arc(2 * pi * radius, way / radius);
       hand.line(hand.random(0.2, 1.5));
     }},
    {"spiral", spiral},
    {"short", [](Hand& hand) { hand.arc(hand.random(0.01, 0.9), hand.random(-4, 4)); }},
    {"scribble", scribble},
    {"eight",
     [](Hand& hand) {
       const double radius = hand.random(0.6, 1.1), way = hand.sign();
       hand.arc(2 * pi * radius, way / radius);
       hand.arc(2 * pi * radius, -way / radius);
     }},
}};

constexpr auto kind_names = [] {
  std::array<std::string_view, kinds.size()> names;
  std::ranges::transform(kinds, names.begin(), [](const auto& kind) { return kind.first; });
  return names;
}();

double distance_in_plane(const Vec2d& x, const Vec2d& a, const Vec2d& b) {
  const Vec2d way = b - a;
  const double squared = way.squaredNorm();
  const double s = squared > 0 ? std::clamp((x - a).dot(way) / squared, 0., 1.) : 0;
  return (x - a - s * way).norm();
}

/// A shape that unrolls onto the plane without distortion.
class Developable : public ExactShape {
 public:
  TriangleMesh mesh(double edge, double reach, std::uint32_t seed) const override {
    const int cells = static_cast<int>(std::ceil(2 * reach / edge));
    return shuffled(patch({.u_min = -reach,
                           .u_max = reach,
                           .v_min = -reach,
                           .v_max = reach,
                           .cells_u = cells,
                           .cells_v = cells,
                           .seed = seed},
                          [this](double u, double v) {
                            return place({u, v});
                          }),
                    seed + 1);
  }
  double distance(const Vec3d& x, const Vec3d& a, const Vec3d& b) const override {
    return distance_in_plane(unrolled(x), unrolled(a), unrolled(b));
  }
  virtual Vec2d unrolled(const Vec3d& at) const = 0;
};

class Plane final : public Developable {
  Vec3d place(const Vec2d& in_plane) const override { return {in_plane.x(), in_plane.y(), 0}; }
  Vec2d unrolled(const Vec3d& at) const override { return at.head<2>(); }
};

class Cylinder final : public Developable {
  Vec3d place(const Vec2d& in_plane) const override {
    return {std::cos(in_plane.x()), std::sin(in_plane.x()), in_plane.y()};
  }
  Vec2d unrolled(const Vec3d& at) const override { return {std::atan2(at.y(), at.x()), at.z()}; }
};

/// A cone about the z axis with its tip at the origin. In the unrolled plane the tip is at (-middle, 0).
class Cone final : public Developable {
  static constexpr double middle = 2, sine = 0.5;
  Vec3d place(const Vec2d& in_plane) const override {
    const double x = in_plane.x() + middle, from_tip = std::hypot(x, in_plane.y());
    const double angle = std::atan2(in_plane.y(), x) / sine;
    return from_tip * Vec3d(sine * std::cos(angle), sine * std::sin(angle), -std::sqrt(1 - sine * sine));
  }
  Vec2d unrolled(const Vec3d& at) const override {
    const double from_tip = at.norm(), angle = sine * std::atan2(at.y(), at.x());
    return {from_tip * std::cos(angle) - middle, from_tip * std::sin(angle)};
  }
};

class Sphere final : public ExactShape {
  TriangleMesh mesh(double edge, double, std::uint32_t seed) const override {
    // An icosahedron has edges of 1.1, and each level halves them.
    const int levels = static_cast<int>(std::lround(std::log2(1.1 / edge)));
    return shuffled(sphere(levels, 0.15, seed), seed + 1);
  }
  Vec3d place(const Vec2d& in_plane) const override {
    const double way = in_plane.norm();
    if (way == 0) return {0, 0, 1};
    const Vec2d flat = std::sin(way) / way * in_plane;
    return {flat.x(), flat.y(), std::cos(way)};
  }
  double distance(const Vec3d& x_near, const Vec3d& a_near, const Vec3d& b_near) const override {
    const Vec3d x = x_near.normalized(), a = a_near.normalized(), b = b_near.normalized();
    const auto angle = [](const Vec3d& u, const Vec3d& v) { return std::atan2(u.cross(v).norm(), u.dot(v)); };
    const Vec3d pole = a.cross(b);
    const double of_ends = std::min(angle(x, a), angle(x, b));
    if (!(pole.norm() > 0)) return of_ends;
    const bool beside = pole.cross(a).dot(x) > 0 && b.cross(pole).dot(x) > 0;
    return beside ? std::abs(std::asin(std::clamp(pole.normalized().dot(x), -1., 1.))) : of_ends;
  }
};

}  // namespace

std::span<const std::string_view> drawn_kinds() { return kind_names; }

std::vector<Vec2d> drawn_stroke(std::string_view kind, std::mt19937& random) {
  const auto found = std::ranges::find(kinds, kind, &std::pair<std::string_view, Draw>::first);
  if (found == kinds.end()) throw std::invalid_argument("no such kind of stroke");
  Hand hand(random);
  found->second(hand);
  return hand.way();
}

std::unique_ptr<ExactShape> exact_plane() { return std::make_unique<Plane>(); }
std::unique_ptr<ExactShape> exact_cylinder() { return std::make_unique<Cylinder>(); }
std::unique_ptr<ExactShape> exact_cone() { return std::make_unique<Cone>(); }
std::unique_ptr<ExactShape> exact_sphere() { return std::make_unique<Sphere>(); }

}  // namespace burin::test
