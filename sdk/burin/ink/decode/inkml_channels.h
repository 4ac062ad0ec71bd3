#pragma once
#include <burin/base/vector.h>
#include <burin/ink/decode/inkml_format.h>
#include <burin/ink/pen_file.h>

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace burin {

/// The values of a point, by channel.
using InkmlValues = std::vector<std::optional<double>>;

/// Makes samples of the values of a trace.
class InkmlChannels {
 public:
  /// `in_space`: Z is a coordinate like X and Y; else the height of the pen above the paper, which is not
  /// used.
  InkmlChannels(const InkmlFormat& format, bool office, bool in_space);

  const InkmlFormat& format() const { return format_; }
  bool in_millimetres() const { return scale_.x() > 0; }
  bool has_elevation() const { return azimuth_ && elevation_; }
  bool has_position() const { return x_ && y_; }
  bool has_height() const { return !z_ && find("Z"); }
  PenStroke empty_stroke() const;
  /// Gives a point the values that it lacks, but position and contact, of the point before where they have no
  /// default. `held`: the last value of each channel so far.
  void hold(InkmlValues& values, InkmlValues& held) const;
  /// Takes the fields from a stroke of which no point has a value.
  void drop_unknown(PenStroke& stroke, const InkmlValues& held) const;
  /// Whether the pen touches; unless a switch of its tip tells otherwise.
  bool touches(const InkmlValues& values) const { return !tip_ || values[*tip_].value_or(1) != 0; }
  Sample sample(const InkmlValues& values, double begin) const;
  /// Whether the values say that the pen is anything but upright, or flat along the x axis.
  bool tilted(const InkmlValues& values) const;

 private:
  using At = std::optional<std::size_t>;
  At find(std::string_view name) const;
  bool known(At at, const InkmlValues& held) const { return at && (held[*at] || channel(at).otherwise); }
  double value(At at, const InkmlValues& values) const;
  double angle(At at, const InkmlValues& values) const;
  float pressure(double force) const;
  const InkmlChannel& channel(At at) const { return format_.channels[*at]; }

  const InkmlFormat& format_;
  At x_, y_, z_, time_, force_, tilt_x_, tilt_y_, azimuth_, elevation_, rotation_, tip_, barrel_;
  Vec3d scale_ = Vec3d::Zero();  ///< millimetres per value; 0: unknown
};

}  // namespace burin
