#pragma once
#include <burin/ink/parse/hid_descriptor.h>
#include <burin/ink/pen_file.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace burin {

/// Makes a stroke of each touch of a device whose reports have one or several, each with its id.
class HidTouches {
 public:
  explicit HidTouches(const std::vector<HidField>& fields);

  /// Takes a report; returns whether it is one of touches.
  bool take(double time, const HidReport& report, PenFile& content);

 private:
  /// Where a report has one of its touches.
  struct Place {
    HidField tip, id, x, y;
    std::optional<HidField> pressure;
  };
  struct Report {
    std::vector<Place> places;
    std::vector<HidField> count;  ///< of touches in the report; none or one
  };
  struct Touch {
    std::int32_t id;
    Vec3d position;
    std::optional<float> pressure;
  };
  /// What a report tells of touches.
  struct Touches {
    std::vector<Touch> down;
    std::vector<std::int32_t> ended;  ///< by id
  };

  Touches touches_in(const Report& kind, const HidReport& report);
  void end(const Touches& touches);
  void add(const Touch& touch, double time, PenFile& content);

  std::map<std::uint8_t, Report> reports_;       ///< by id
  std::size_t left_ = 0;                         ///< touches of a frame that reports have yet to tell
  std::map<std::int32_t, std::size_t> strokes_;  ///< that go on, of the content, by the id of the touch
};

}  // namespace burin
