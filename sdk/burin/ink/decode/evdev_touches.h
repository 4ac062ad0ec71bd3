#pragma once
#include <burin/ink/parse/evdev_axes.h>
#include <burin/ink/pen_file.h>

#include <array>
#include <cstddef>
#include <map>
#include <optional>

namespace burin {

/// Makes a stroke of each touch of a device that follows several at a time: the kernel's multi-touch protocol
/// with slots. Such devices also send the position of one touch as if it were a pen, which jumps when that
/// one ends. Events of devices without slots are passed over: these send all touches one after the other.
class EvdevTouches {
 public:
  /// `axes` must outlive the object.
  explicit EvdevTouches(const EvdevAxes& axes);

  /// Whether an axis is one of touches.
  static bool is_of_touches(unsigned code);

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
    int id = -1;                        ///< of the touch; -1: none
    bool changed = false;               ///< in the frame
    std::map<unsigned, int> values;     ///< of axes, as last sent
    std::optional<std::size_t> stroke;  ///< of the content
  };

  void add_sample(Slot& slot, double time, PenFile& content);

  const EvdevAxes& axes_;
  std::array<Slot, 64> slots_;  ///< far more than devices have; those beyond are passed over
  bool has_slots_;
  std::size_t slot_ = 0;
};

}  // namespace burin
