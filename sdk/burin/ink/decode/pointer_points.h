#pragma once
#include <burin/base/text/json_value.h>
#include <burin/ink/pen_file.h>

#include <array>
#include <optional>
#include <string_view>

namespace burin {

/// A value that points of web programs have beside x and y.
struct PointerChannel {
  std::array<std::string_view, 4> names;  ///< the first that a point has counts; empty ones are none
  void (*set)(Sample& sample, double value) = nullptr;
  bool PenFields::*field = nullptr;
};

extern const std::array<PointerChannel, 5> pointer_channels;
inline constexpr std::size_t pressure_channel = 1, tilt_x_channel = 2, tilt_y_channel = 3;

/// The member of a value that has this name, unless it is null.
std::optional<JsonValue> told(const JsonValue& value, std::string_view name);

/// The member of a value that gives it a channel; null is none.
std::optional<JsonValue> channel_of(const JsonValue& value, const PointerChannel& channel);

/// Where the pen's upper end points to, radians: what events have beside tiltX and tiltY, or instead of them.
inline constexpr std::string_view altitude_name = "altitudeAngle", azimuth_name = "azimuthAngle";

/// tiltX and tiltY, degrees, of an altitude above the plane and an azimuth from +x towards +y, radians.
std::array<double, 2> tilts_of(double altitude, double azimuth);

/// Sets channels that not all samples have to what a pen without them has.
void keep_channels(PenStroke& stroke, const std::array<bool, pointer_channels.size()>& whole);

/// What a device reports, as against what programs make of the speed and call pressure too.
inline constexpr std::string_view reported_pressure = "pressure";

/// DrawnBy::tool of a PointerEvent's pointerType, in any case; empty for others.
std::string_view tool_of_pointer_type(std::string_view type);

/// Whether the `type` of an element says that it is no stroke, in files of MyScript's programs.
bool is_shape_of_program(std::string_view type);

/// Members of an element that have the strokes of a group.
inline constexpr std::array<std::string_view, 2> groups_of_strokes = {"children", "strokes"};

/// Reads one stroke: a list of points, flat objects of numbers, or an object with such a list as "pointers"
/// or "points". Needs no memory but for the samples. Returns nothing for malformed JSON, and for whatever
/// else may be a stroke, a group, a shape or a fault; one without samples for an object without points.
std::optional<PenStroke> plain_pointer_stroke(std::string_view json);

}  // namespace burin
