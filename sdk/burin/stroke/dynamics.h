#pragma once
#include <burin/stroke/pen.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// What of the pen, or of the stroke's course, drives a value along the stroke. Angles lie in -pi..pi.
enum class PenSource {
  pressure,        ///< 0..1
  tilt,            ///< radians from upright, 0..pi/2
  tilt_direction,  ///< of the pen's upper end, radians from the x axis to the y axis of the tilts; upright: 0
  direction,       ///< of travel, radians; see travel_direction()
  speed,           ///< radii a second, so that the units of the mesh do not matter; as CurvePoint::speed
  time,            ///< seconds since the first sample
  t,               ///< radii along the stroke from its begin
  random,          ///< 0..1, smooth noise along the stroke: a new value every radius
};

/// "tilt_direction", as files and command lines have it.
std::string_view source_name(PenSource source);
std::optional<PenSource> source_named(std::string_view name);
/// All of them, "pressure, tilt, ...".
std::string source_names();

/// Lets a source drive a value. What the curve gives multiplies the value, but is added to an angle; several
/// dynamics of one target act together. A source that the recording lacks leaves the target alone.
struct Dynamic {
  std::string target;  ///< "radius", "strength" or the id of a dynamic parameter of the brush
  PenSource source = PenSource::pressure;
  std::vector<double> curve;  ///< x0 y0 x1 y1 ..., x rising; straight lines between, constant beyond

  bool operator==(const Dynamic&) const = default;
};

/// Those of `theirs` whose target none of `mine` has, then `mine`.
std::vector<Dynamic> replaced(const std::vector<Dynamic>& theirs, const std::vector<Dynamic>& mine);

/// The stroke whose values are driven.
struct DrivenStroke {
  PenFields fields;        ///< what the recording has
  double radius = 1;       ///< object units
  std::uint64_t seed = 0;  ///< of PenSource::random, together with the target's name
  /// From a symmetric image of a stroke back to the one drawn by hand, whose direction of travel counts.
  Mat3f to_hand = Mat3f::Identity();
};

/// The dynamics of one target that the recording can drive. The value is a function of the place on the
/// curve alone. Any thread.
class TargetDynamics {
 public:
  TargetDynamics() = default;  ///< none

  /// Takes those of `dynamics` with this target. They must be without fault.
  TargetDynamics(std::span<const Dynamic> dynamics, std::string_view target, const DrivenStroke& stroke);

  bool empty() const { return dynamics_.empty(); }

  /// Product of the curves, each held within [low, high] first; 1 without any. `loop`: the length of a
  /// closed curve, around which the noise closes; 0 for an open one.
  double product(const PenAt& at, double loop, double low = -most, double high = most) const;
  /// Their sum; 0 without any.
  double sum(const PenAt& at, double loop) const;
  /// What the product does not fall below anywhere when low >= 0.
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

/// Angle from the object's x axis, projected onto the tangent plane, to the tangent, counter-clockwise seen
/// from outside: -pi..pi. Where the normal is within 0.001 radians of the x axis, from the y axis instead.
double travel_direction(const Vec3f& tangent, const Vec3f& normal);

/// The width of a stroke along its curve, a share of the radius: what the pen's pressure decides of it and
/// what the dynamics of "radius" make of it.
class StrokeWidth {
 public:
  StrokeWidth() = default;  ///< 1 everywhere

  /// `pressure_width`: 0..1, share of the width that the pressure decides, where there is one: the width is
  /// 1 - pressure_width * (1 - pressure). Curves of "radius" are held within 0.02..1, and so is the product.
  StrokeWidth(double pressure_width, std::span<const Dynamic> dynamics, const DrivenStroke& stroke);

  bool varies() const { return pressure_width_ > 0 || !dynamics_.empty(); }
  /// No width is smaller.
  double narrowest() const;
  /// `loop`: as TargetDynamics takes it.
  float at(const PenAt& at, double loop) const;

 private:
  double pressure_width_ = 0;
  TargetDynamics dynamics_;
};

}  // namespace burin
