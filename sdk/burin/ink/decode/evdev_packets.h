#pragma once
#include <burin/ink/decode/evdev_touches.h>
#include <burin/ink/parse/evdev_axes.h>
#include <burin/ink/pen_file.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace burin {

/// Makes a stroke of each touch of a device without slots: the kernel's multi-touch protocol of type A, whose
/// frames have a packet for every touch that there is. Touches that tell ids are followed by these, others by
/// their places: the nearest ones of two frames are one touch.
class EvdevPackets {
 public:
  /// `axes` must outlive the object.
  explicit EvdevPackets(const EvdevAxes& axes) : axes_(axes) {}

  /// Takes an event of an axis of touches.
  void take(unsigned code, int value) { packet_[code] = value; }

  /// Takes the end of a packet. An empty one tells that there is no touch.
  void end_packet();

  /// Takes it that nothing touches, which frames without a packet tell by other events.
  void lift() { has_packets_ = true; }

  /// Adds a sample to the stroke of each touch of the frame. Returns whether there is a touch.
  bool end_frame(double time, PenFile& content);

  /// Ends all strokes, since events were lost.
  void part_strokes() { touches_.clear(); }

 private:
  struct Touch {
    EvdevValues values;
    std::optional<std::size_t> stroke;  ///< of the content
  };
  static bool have_ids(const std::vector<Touch>& touches);
  void follow_ids(std::vector<Touch>& now) const;
  void follow_places(std::vector<Touch>& now) const;

  const EvdevAxes& axes_;
  EvdevValues packet_;
  bool has_packets_ = false;            ///< in the frame, or events that stand for an empty one
  std::vector<Touch> frame_, touches_;  ///< of the frame, and of the one before
};

}  // namespace burin
