#pragma once
#include <burin/ink/decode/evdev_packets.h>
#include <burin/ink/decode/evdev_touches.h>
#include <burin/ink/parse/evdev_axes.h>
#include <burin/ink/pen_file.h>

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace burin {

/// An event of the kernel's input system.
struct EvdevEvent {
  double time = 0;  ///< seconds
  unsigned type = 0, code = 0;
  int value = 0;
};

/// Makes strokes of the events of a tablet. Events take effect at the end of their frame, in whatever order
/// they came in it; a frame has only what changed.
class EvdevFrames {
 public:
  explicit EvdevFrames(EvdevAxes axes) : axes_(std::move(axes)), touches_(axes_), packets_(axes_) {}
  EvdevFrames(const EvdevFrames&) = delete;
  EvdevFrames& operator=(const EvdevFrames&) = delete;

  void take(const EvdevEvent& event);

  /// Strokes, the unit of their positions, and the count of frames without contact.
  PenFile finish();

 private:
  void end_frame(double time);
  bool pen_leaves() const;
  void apply(const EvdevEvent& event);
  void set_axis(unsigned code, int value);
  bool pen_is_near() const;
  bool touches() const;
  void add_sample(double time);
  const EvdevAxis* axis(unsigned code) const { return axis_of(axes_, code); }
  /// Sets what `fields` has. Values that were not sent are 0.
  void set_pen(const PenFields& fields, const EvdevValues& values, Pen& pen) const;
  static double tilt(const EvdevAxis& range, double value);
  static double twist(const EvdevAxis& range, double value);
  void drop_still_twist();
  void set_fields(PenStroke& stroke) const;

  EvdevAxes axes_;
  EvdevTouches touches_;
  EvdevPackets packets_;
  std::vector<EvdevEvent> frame_;
  EvdevValues values_;
  std::optional<unsigned> tool_;               ///< the code of the tool that is near
  std::array<std::optional<bool>, 2> stylus_;  ///< buttons at the pen's side; empty: none was sent
  bool sends_tools_ = false, touch_ = false, lost_ = false;
  std::optional<std::size_t> stroke_;  ///< of `content_`, that goes on
  PenFile content_;
};

}  // namespace burin
