#pragma once
#include <burin/ink/parse/evdev_axes.h>
#include <burin/ink/pen_file.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

namespace burin {

/// Makes a stroke of each touch of a device that follows several at a time: the kernel's multi-touch protocol
/// with slots. Such devices also send the position of one touch as if it were a pen, which jumps when that
/// one ends.
class EvdevTouches {
 public:
  /// `axes` must outlive the object.
  explicit EvdevTouches(const EvdevAxes& axes) : axes_(axes) {}

  /// Whether an axis is one of touches.
  static bool is_of_touches(unsigned code);

  /// Takes an event of such an axis.
  void take(unsigned code, int value);

  /// Adds a sample to the stroke of each touch. Returns whether there is one.
  bool end_frame(double time, PenFile& content);

  /// Ends all strokes, since events were lost.
  void part_strokes();

 private:
  struct Slot {
    bool down = false;
    std::map<unsigned, int> values;     ///< of axes, as last sent
    std::optional<std::size_t> stroke;  ///< of the content
  };

  void add_sample(Slot& slot, double time, PenFile& content);

  const EvdevAxes& axes_;
  std::map<int, Slot> slots_;
  int slot_ = 0;
};

}  // namespace burin
