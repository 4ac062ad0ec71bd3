#pragma once
#include <burin/ink/parse/evdev_axes.h>
#include <burin/ink/pen_file.h>

#include <array>
#include <cstddef>
#include <map>
#include <optional>

namespace burin {

// Axes of touches, as linux/input-event-codes.h has them.
inline constexpr unsigned abs_mt_slot = 0x2f, abs_mt_touch_major = 0x30, abs_mt_position_x = 0x35,
                          abs_mt_position_y = 0x36, abs_mt_tracking_id = 0x39, abs_mt_pressure = 0x3a,
                          abs_mt_distance = 0x3b, abs_mt_last = 0x3d;

using EvdevValues = std::map<unsigned, int>;  ///< of axes, as last sent

/// Whether these tell a place, and no distance from the surface.
bool is_on_surface(const EvdevValues& values);

/// Adds a sample of a touch to its stroke, which is begun if there is none.
void add_touch_sample(const EvdevAxes& axes, const EvdevValues& values, double time,
                      std::optional<std::size_t>& stroke, PenFile& content);

/// Makes a stroke of each touch of a device that follows several at a time: the kernel's multi-touch protocol
/// with slots, type B. Such devices also send the position of one touch as if it were a pen, which jumps when
/// that one ends. Events of devices without slots are passed over: see EvdevPackets.
class EvdevTouches {
 public:
  /// `axes` must outlive the object.
  explicit EvdevTouches(const EvdevAxes& axes);

  /// Whether an axis is one of touches.
  static bool is_of_touches(unsigned code);

  /// Whether the device has slots, as far as events tell.
  bool has_slots() const { return has_slots_; }

  /// Takes an event of such an axis.
  void take(unsigned code, int value);

  /// Adds a sample to the stroke of each touch that events were taken of. Returns whether there is a touch.
  bool end_frame(double time, PenFile& content);

  /// Ends all strokes, since events were lost.
  void part_strokes();

 private:
  enum class Contact { unknown, up, down };
  struct Slot {
    void take(unsigned code, int value);
    bool touches() const;

    Contact contact = Contact::unknown;
    int id = -1;           ///< of the touch; -1: none
    bool changed = false;  ///< in the frame
    EvdevValues values;
    std::optional<std::size_t> stroke;  ///< of the content
  };

  const EvdevAxes& axes_;
  std::array<Slot, 64> slots_;  ///< far more than devices have; those beyond are passed over
  bool has_slots_;
  std::size_t slot_ = 0;
};

}  // namespace burin
