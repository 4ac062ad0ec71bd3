#pragma once
#include <burin/stroke/pen.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// The free functions may be called on any thread, also on several at once.
namespace burin {

/// A quantity of the pen or of the curve that drives a value along the stroke. Angles lie in -pi..pi.
enum class PenSource {
  pressure,        ///< 0..1
  tilt,            ///< radians from upright, 0..pi/2
  tilt_direction,  ///< of the pen's upper end, radians from the x axis to the y axis of the tilts; upright: 0
  direction,       ///< direction of travel, radians; see travel_direction()
  speed,           ///< CurvePoint::speed in radii per second, so that the units of the mesh do not matter
  time,            ///< seconds since the first sample
  t,               ///< arc length from the start of the stroke, in radii
  random,          ///< 0..1, smooth noise along the stroke: a new value every radius
};

/// The name of a source in files and on command lines, such as "tilt_direction".
std::string_view source_name(PenSource source);
/// The source with this name, or nothing.
std::optional<PenSource> parse_source(std::string_view name);
/// The names of all sources: "pressure, tilt, ...".
std::string source_names();

/// Lets a source drive a value. The curve maps the source to a factor of the value, or to a summand if the
/// value is an angle. Several dynamics of one target are combined. A dynamic whose source the recording lacks
/// has no effect.
struct Dynamic {
  std::string target;  ///< "radius", "strength" or the id of a dynamic parameter of the brush
  PenSource source = PenSource::pressure;
  std::vector<double> curve;  ///< x0 y0 x1 y1 ..., x increasing; linear between knots, constant beyond

  bool operator==(const Dynamic&) const = default;
};

/// The dynamics of `theirs` whose targets do not occur in `mine`, followed by `mine`.
std::vector<Dynamic> replaced(const std::vector<Dynamic>& theirs, const std::vector<Dynamic>& mine);

/// What TargetDynamics needs of the stroke whose values are driven.
struct DrivenStroke {
  PenFields fields;        ///< fields that the pen reports
  double radius = 1;       ///< object units
  std::uint64_t seed = 0;  ///< seed of PenSource::random, combined with the target's name
  /// Maps a symmetric image of a stroke back to the stroke as drawn, whose direction of travel is used.
  Mat3f to_hand = Mat3f::Identity();
};

/// The dynamics of one target whose sources the recording has. Values depend only on the point of the curve.
/// Any thread.
class TargetDynamics {
 public:
  TargetDynamics() = default;  ///< none

  /// Selects the dynamics with this target. validation_error() must accept each of them.
  TargetDynamics(std::span<const Dynamic> dynamics, std::string_view target, const DrivenStroke& stroke);

  /// Whether nothing drives the target.
  bool empty() const { return dynamics_.empty(); }

  /// The product of the curves' values, each clamped to [low, high]; 1 without any. `loop`: the length of a
  /// closed curve, over which the noise is periodic, or 0 for an open one.
  double product(const PenAt& at, double loop, double low = -most, double high = most) const;
  /// The sum of the curves' values; 0 without any.
  double sum(const PenAt& at, double loop) const;
  /// A lower bound of product() along any stroke, for low >= 0.
  double least_product(double low, double high) const;

 private:
  static constexpr double most = std::numeric_limits<float>::max();

  double source_value(PenSource source, const PenAt& at, double loop) const;
  double curve_value(const Dynamic& dynamic, const PenAt& at, double loop) const;

  std::vector<Dynamic> dynamics_;
  double radius_ = 1;
  Mat3f to_hand_ = Mat3f::Identity();
  std::uint64_t noise_key_ = 0;
};

/// The angle from the object's x axis, projected onto the tangent plane, to the tangent, counter-clockwise
/// seen from outside, -pi..pi. If the normal is within 0.001 radians of the x axis, the y axis takes its
/// place.
double travel_direction(const Vec3f& tangent, const Vec3f& normal);

/// The width of a stroke along its curve as a share of the radius, from the pen's pressure and the dynamics
/// of "radius". Any thread.
class StrokeWidth {
 public:
  StrokeWidth() = default;  ///< 1 everywhere

  /// `pressure_width`: 0..1. If the pen reports pressure, the width is 1 - pressure_width * (1 - pressure),
  /// multiplied by the curves of "radius". Each curve and the product are clamped to 0.02..1.
  StrokeWidth(double pressure_width, std::span<const Dynamic> dynamics, const DrivenStroke& stroke);

  /// Whether it is other than 1 anywhere.
  bool varies() const { return pressure_width_ > 0 || !dynamics_.empty(); }
  /// A lower bound of the width.
  double narrowest() const;
  /// `loop`: see TargetDynamics::product().
  float at(const PenAt& at, double loop) const;

 private:
  double pressure_width_ = 0;
  TargetDynamics dynamics_;
};

}  // namespace burin
