// Follows touches by their ids. A report has room for one or some of them, and tells how many there are; what
// room is left holds zeros. More touches than there is room for come in reports that follow, whose count is
// 0.
#include <burin/ink/decode/hid_touches.h>

#include <algorithm>
#include <array>
#include <utility>

namespace burin {
namespace {

constexpr std::size_t most_touches = 64;  // in a report; more than any device has

constexpr std::array usages_of_pens{usage_barrel, usage_eraser, usage_tilt_x};

/// Fields of touches in a report, in its order.
struct TouchFields {
  std::vector<HidField> tips, ids, x, y, pressures, counts;
  bool of_pen = false;  ///< has what only pens have

  std::vector<HidField>* of(std::uint32_t usage) {
    switch (usage) {
      case usage_tip:
        return &tips;
      case usage_contact_id:
        return &ids;
      case usage_x:
        return &x;
      case usage_y:
        return &y;
      case usage_pressure:
        return &pressures;
      case usage_contact_count:
        return &counts;
      default:
        return nullptr;
    }
  }
};

std::map<std::uint8_t, TouchFields> fields_by_report(const std::vector<HidField>& fields) {
  std::map<std::uint8_t, TouchFields> reports;
  for (const HidField& field : fields) {
    TouchFields& of_report = reports[field.report];
    std::vector<HidField>* same = of_report.of(field.usage);
    if (same && same->size() < most_touches) same->push_back(field);
    of_report.of_pen |= std::ranges::find(usages_of_pens, field.usage) != usages_of_pens.end();
  }
  return reports;
}

/// The pressure of a touch, if all have one.
std::optional<HidField> pressure_of(const TouchFields& of, std::size_t touch) {
  const bool all = of.pressures.size() == of.tips.size();
  const bool ranged = all && of.pressures[touch].most > of.pressures[touch].least;
  return ranged ? std::optional(of.pressures[touch]) : std::nullopt;
}

}  // namespace

HidTouches::HidTouches(const std::vector<HidField>& fields) {
  for (auto& [id, of] : fields_by_report(fields)) {
    Report& report = reports_[id];
    const std::size_t touches = std::min({of.tips.size(), of.ids.size(), of.x.size(), of.y.size()});
    const bool has_touches = touches > 1 || !of.of_pen;
    for (std::size_t i = 0; has_touches && i < touches; ++i)
      report.places.push_back({of.tips[i], of.ids[i], of.x[i], of.y[i], pressure_of(of, i)});
    report.count = std::move(of.counts);
  }
}

bool HidTouches::take(double time, const HidReport& report, PenFile& content) {
  const auto known = reports_.find(report.id);
  if (known == reports_.end() || known->second.places.empty()) return false;
  const Touches touches = touches_in(known->second, report);
  if (hid_millimetres(known->second.places.front().x) > 0) content.unit = "mm";
  end(touches);
  for (const Touch& touch : touches.down) add(touch, time, content);
  if (touches.down.empty()) ++content.hovering;
  return true;
}

HidTouches::Touches HidTouches::touches_in(const Report& kind, const HidReport& report) {
  const auto value = [&](const HidField& field) { return report.has(field) ? hid_value(field, report) : 0; };
  const std::int32_t count =
      kind.count.empty() ? static_cast<std::int32_t>(most_touches) : value(kind.count.front());
  if (count > 0) left_ = static_cast<std::size_t>(count);
  Touches touches;
  for (const Place& place : kind.places) {
    const bool counts = left_ > 0;
    if (counts) --left_;
    if (value(place.tip) != 0)
      touches.down.push_back(
          {value(place.id),
           {hid_position(place.x, value(place.x)), hid_position(place.y, value(place.y)), 0},
           place.pressure ? std::optional(hid_share(*place.pressure, value(*place.pressure)))
                          : std::nullopt});
    else if (counts)
      touches.ended.push_back(value(place.id));
  }
  return touches;
}

/// Ends touches, unless the same report has them down: rooms without a touch have an id too.
void HidTouches::end(const Touches& touches) {
  for (const std::int32_t id : touches.ended)
    if (std::ranges::find(touches.down, id, &Touch::id) == touches.down.end()) strokes_.erase(id);
}

void HidTouches::add(const Touch& touch, double time, PenFile& content) {
  const auto [stroke, begins] = strokes_.try_emplace(touch.id, content.strokes.size());
  if (begins) {
    PenStroke& made = content.strokes.emplace_back();
    made.drawn_by.tool = "touch";
    made.fields.time = true;
    made.fields.pressure = touch.pressure.has_value();
  }
  Sample& sample = content.strokes[stroke->second].samples.emplace_back();
  sample.time = time;
  sample.position = touch.position;
  if (touch.pressure) sample.pen.pressure = *touch.pressure;
}

}  // namespace burin
