// Simulates the motion of a hand along a path: a speed for each point, limited forwards and backwards by the
// acceleration, then times, tremor, pressure and tilt at a fixed rate of reports.
#include <burin/math/elementary.h>

#include "pen_motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>

namespace burin::samples {

namespace {

constexpr std::size_t steps = 4000;  // number of steps of the path's parameter
constexpr double reports_per_second = 240;

/// A sum of three sines with random phases, within -1..1.
class Waver {
 public:
  Waver(std::mt19937_64& random, std::array<double, 3> hertz) : hertz_(hertz) {
    for (double& phase : phases_)
      phase = 2 * std::numbers::pi * std::ldexp(static_cast<double>(random() >> 11), -53);
  }

  double operator()(double time) const {
    double sum = 0;
    for (std::size_t i = 0; i < hertz_.size(); ++i)
      sum += math::sin(2 * std::numbers::pi * hertz_[i] * time + phases_[i]);
    return sum / 3;
  }

 private:
  std::array<double, 3> hertz_;
  std::array<double, 3> phases_{};
};

std::vector<Vec3d> path_points(const PenPath& path) {
  std::vector<Vec3d> points(steps + 1);
  for (std::size_t i = 0; i <= steps; ++i) points[i] = path(static_cast<double>(i) / steps);
  return points;
}

/// The curvature of the circle through a point and the points 20 steps before and after it.
double curvature(const std::vector<Vec3d>& points, std::size_t i) {
  constexpr std::size_t reach = 20;
  const Vec3d& before = points[i < reach ? 0 : i - reach];
  const Vec3d& after = points[std::min(i + reach, steps)];
  const Vec3d a = points[i] - before, b = after - points[i], c = after - before;
  const double product = a.norm() * b.norm() * c.norm();
  return product > 0 ? 2 * a.cross(b).norm() / product : 0;
}

/// The speed at each point, limited by the bend there and by the acceleration from and to its neighbours.
std::vector<double> speeds(const std::vector<Vec3d>& points, const PenStyle& style) {
  const double rest = style.speed / 20;
  std::vector<double> speed(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    speed[i] = style.speed *
               std::min(1., math::pow(std::max(curvature(points, i) * style.bend_radius, 1.), -1. / 3));
  speed.front() = speed.back() = rest;
  const auto limit = [&](std::size_t from, std::size_t to) {
    const double way = (points[to] - points[from]).norm();
    speed[to] = std::min(speed[to], std::sqrt(speed[from] * speed[from] + 2 * style.acceleration * way));
  };
  for (std::size_t i = 0; i < steps; ++i) limit(i, i + 1);
  for (std::size_t i = steps; i > 0; --i) limit(i, i - 1);
  return speed;
}

std::vector<double> arrival_times(const std::vector<Vec3d>& points, const std::vector<double>& speed) {
  std::vector<double> times(points.size(), 0.);
  for (std::size_t i = 0; i < steps; ++i)
    times[i + 1] = times[i] + 2 * (points[i + 1] - points[i]).norm() / (speed[i] + speed[i + 1]);
  return times;
}

/// The pressure, 0..1. The pen touches down within 80 ms and lifts off within 150 ms.
float pressure_at(double time, double duration, double relative_speed, double waver) {
  const double touch = std::min({1., time / .08 + .08, (duration - time) / .15 + .05});
  return static_cast<float>(std::clamp(touch * (.82 - .25 * relative_speed + .05 * waver), 0., 1.));
}

}  // namespace

std::vector<PenEvent> draw(const PenPath& path, const PenStyle& style) {
  const std::vector<Vec3d> points = path_points(path);
  const std::vector<double> speed = speeds(points, style);
  const std::vector<double> times = arrival_times(points, speed);
  std::mt19937_64 random(style.seed);
  const std::array tremor{Waver(random, {8.3, 9.7, 11.6}), Waver(random, {8.1, 10.1, 11.9}),
                          Waver(random, {8.6, 9.2, 11.2})};
  const Waver pressing(random, {.7, 1.3, 2.9}), tilting(random, {.2, .5, .9}), leaning(random, {.3, .4, .8});

  std::vector<PenEvent> events;
  std::size_t i = 0;
  for (std::size_t report = 0;; ++report) {
    const double time = static_cast<double>(report) / reports_per_second;
    if (time > times.back()) return events;
    while (i + 1 < steps && times[i + 1] < time) ++i;
    const double part = (time - times[i]) / (times[i + 1] - times[i]);
    const double speed_here = speed[i] + part * (speed[i + 1] - speed[i]);
    events.push_back({time,
                      (static_cast<double>(i) + part) / steps,
                      style.tremor * Vec3d(tremor[0](time), tremor[1](time), tremor[2](time)),
                      {.pressure = pressure_at(time, times.back(), speed_here / style.speed, pressing(time)),
                       .tilt_x = static_cast<float>(.45 + .12 * tilting(time)),
                       .tilt_y = static_cast<float>(-.20 + .15 * leaning(time))}});
  }
}

}  // namespace burin::samples
