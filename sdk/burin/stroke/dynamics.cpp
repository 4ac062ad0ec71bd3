// Evaluates dynamics: the value of a source at a point of the curve, a piecewise linear function of it, and
// the product or sum over all dynamics of a target. The random source is value noise whose lattice values
// come from a hash.
#include <burin/base/hash.h>
#include <burin/math/elementary.h>
#include <burin/stroke/dynamics.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace burin {
namespace {

constexpr std::array<std::pair<std::string_view, PenSource>, 8> sources{
    {{"pressure", PenSource::pressure},
     {"tilt", PenSource::tilt},
     {"tilt_direction", PenSource::tilt_direction},
     {"direction", PenSource::direction},
     {"speed", PenSource::speed},
     {"time", PenSource::time},
     {"t", PenSource::t},
     {"random", PenSource::random}}};

constexpr double narrowest_share = 0.02;

bool is_there(PenSource source, const PenFields& fields) {
  switch (source) {
    case PenSource::pressure:
      return fields.pressure;
    case PenSource::tilt:
    case PenSource::tilt_direction:
      return fields.tilt;
    case PenSource::speed:
    case PenSource::time:
      return fields.time;
    default:
      return true;
  }
}

/// The horizontal offset of the upper end of a pen of unit height from its tip.
Vec2d lean(const Pen& pen) {
  // A float that rounding put beyond 90 degrees would have a tangent of the wrong sign.
  constexpr double flat = std::numbers::pi / 2;
  return {math::tan(std::clamp(double{pen.tilt_x}, -flat, flat)),
          math::tan(std::clamp(double{pen.tilt_y}, -flat, flat))};
}

/// Interpolates linearly between the knots x0 y0 x1 y1 ...; the value is constant beyond them.
double piecewise_linear(std::span<const double> knots, double x) {
  if (x <= knots[0]) return knots[1];
  for (std::size_t i = 2; i < knots.size(); i += 2) {
    if (x >= knots[i]) continue;
    const double s = (x - knots[i - 2]) / (knots[i] - knots[i - 2]);
    return knots[i - 1] + s * (knots[i + 1] - knots[i - 1]);
  }
  return knots.back();
}

/// A random number in 0..1 that is the same in every run and on every machine: bits of a hash of the key (of
/// stroke and target) and the number of the cell.
double random_number(std::uint64_t key, std::int64_t cell) {
  const std::array<std::uint64_t, 2> counter{key, static_cast<std::uint64_t>(cell)};
  return std::ldexp(static_cast<double>(hash_bytes(counter.data(), sizeof(counter)) >> 11), -53);
}

/// Value noise in cells of one radius, with zero slope at the borders of cells. For a closed stroke the
/// number of cells is rounded to a whole one, and the noise is periodic.
double value_noise(std::uint64_t key, double t, double radius, double loop) {
  const double around = loop > 0 ? std::max(1., std::round(loop / radius)) : 0;
  const double place = loop > 0 ? t / loop * around : t / radius, cell = std::floor(place);
  const auto value = [&](double of_cell) {
    return random_number(key, static_cast<std::int64_t>(
                                  around > 0 ? of_cell - around * std::floor(of_cell / around) : of_cell));
  };
  const double s = place - cell, from = value(cell);
  return from + s * s * (3 - 2 * s) * (value(cell + 1) - from);
}

}  // namespace

std::string_view source_name(PenSource source) {
  return std::ranges::find(sources, source, &std::pair<std::string_view, PenSource>::second)->first;
}

std::optional<PenSource> parse_source(std::string_view name) {
  for (const auto& [known, source] : sources)
    if (known == name) return source;
  return std::nullopt;
}

std::string source_names() {
  std::string names;
  for (const auto& [name, source] : sources) names.append(names.empty() ? "" : ", ").append(name);
  return names;
}

std::vector<Dynamic> replaced(const std::vector<Dynamic>& theirs, const std::vector<Dynamic>& mine) {
  std::vector<Dynamic> all;
  for (const Dynamic& dynamic : theirs)
    if (std::ranges::find(mine, dynamic.target, &Dynamic::target) == mine.end()) all.push_back(dynamic);
  all.insert(all.end(), mine.begin(), mine.end());
  return all;
}

TargetDynamics::TargetDynamics(std::span<const Dynamic> dynamics, std::string_view target,
                               const DrivenStroke& stroke)
    : radius_(stroke.radius), to_hand_(stroke.to_hand) {
  for (const Dynamic& dynamic : dynamics)
    if (dynamic.target == target && is_there(dynamic.source, stroke.fields)) dynamics_.push_back(dynamic);
  const std::array<std::uint64_t, 2> key{stroke.seed, hash_bytes(target.data(), target.size())};
  noise_key_ = hash_bytes(key.data(), sizeof(key));
}

double TargetDynamics::source_value(PenSource source, const PenAt& at, double loop) const {
  switch (source) {
    case PenSource::pressure:
      return at.pen.pressure;
    case PenSource::tilt:
      return math::atan(lean(at.pen).norm());
    case PenSource::tilt_direction:
      return math::atan2(lean(at.pen).y(), lean(at.pen).x());
    case PenSource::direction:
      return travel_direction(to_hand_ * at.tangent, to_hand_ * at.normal);
    case PenSource::speed:
      return at.speed / radius_;
    case PenSource::time:
      return at.time;
    case PenSource::t:
      return at.t / radius_;
    default:
      return value_noise(noise_key_, at.t, radius_, loop);
  }
}

double TargetDynamics::curve_value(const Dynamic& dynamic, const PenAt& at, double loop) const {
  return piecewise_linear(dynamic.curve, source_value(dynamic.source, at, loop));
}

double TargetDynamics::product(const PenAt& at, double loop, double low, double high) const {
  double product = 1;
  for (const Dynamic& dynamic : dynamics_)
    product = std::clamp(product * std::clamp(curve_value(dynamic, at, loop), low, high), -most, most);
  return product;
}

double TargetDynamics::sum(const PenAt& at, double loop) const {
  double sum = 0;
  for (const Dynamic& dynamic : dynamics_) sum += curve_value(dynamic, at, loop);
  return sum;
}

double TargetDynamics::least_product(double low, double high) const {
  double product = 1;
  for (const Dynamic& dynamic : dynamics_) {
    double least = most;
    for (std::size_t i = 1; i < dynamic.curve.size(); i += 2) least = std::min(least, dynamic.curve[i]);
    product *= std::clamp(least, low, high);
  }
  return product;
}

double travel_direction(const Vec3f& tangent, const Vec3f& normal) {
  const Vec3d along = tangent.cast<double>(), up = normal.cast<double>().normalized();
  Vec3d axis = Vec3d::UnitX() - up.x() * up;
  constexpr double sine = 1e-3;
  if (axis.squaredNorm() < sine * sine) axis = Vec3d::UnitY() - up.y() * up;
  return math::atan2(up.dot(axis.cross(along)), axis.dot(along));
}

StrokeWidth::StrokeWidth(double pressure_width, std::span<const Dynamic> dynamics, const DrivenStroke& stroke)
    : pressure_width_(stroke.fields.pressure ? pressure_width : 0), dynamics_(dynamics, "radius", stroke) {}

double StrokeWidth::narrowest() const {
  return std::max((1 - pressure_width_) * dynamics_.least_product(narrowest_share, 1), narrowest_share);
}

float StrokeWidth::at(const PenAt& at, double loop) const {
  const double by_pressure = 1 - pressure_width_ * (1 - static_cast<double>(at.pen.pressure));
  const double width = by_pressure * dynamics_.product(at, loop, narrowest_share, 1);
  return static_cast<float>(std::max(width, narrowest_share));
}

}  // namespace burin
