#pragma once
#include <burin/ink/pen_file.h>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace burin {

/// The range of an axis of a tablet, as its driver tells it.
struct EvdevAxis {
  double least = 0, most = 0;
  double resolution = 0;  ///< values per mm, or per radian; 0: unknown
};

using EvdevAxes = std::map<unsigned, EvdevAxis>;  ///< by the code of the axis

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
  explicit EvdevFrames(EvdevAxes axes) : axes_(std::move(axes)) {}

  void take(const EvdevEvent& event);

  /// Strokes, the unit of their positions, and the count of frames without contact.
  PenFile finish();

 private:
  void end_frame(double time);
  bool pen_leaves() const;
  void apply(const EvdevEvent& event);
  bool touches() const;
  void add_sample(double time);
  const EvdevAxis* axis(unsigned code) const;
  double position(unsigned code) const;
  double tilt(unsigned code) const;
  bool has_millimetres() const;
  void set_fields(PenStroke& stroke) const;

  EvdevAxes axes_;
  std::vector<EvdevEvent> frame_;
  std::map<unsigned, int> values_;  ///< of axes, as last sent
  std::optional<unsigned> tool_;    ///< the code of the tool that is near
  bool sends_tools_ = false, touch_ = false, lost_ = false;
  bool down_ = false;  ///< the last stroke of `content_` goes on
  PenFile content_;
};

}  // namespace burin
