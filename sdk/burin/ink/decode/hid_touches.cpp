// Follows touches by their ids. A report has room for some of them, and tells how many are in it; what room
// is left holds zeros. More touches than there is room for come in reports that follow.
#include <burin/ink/decode/hid_touches.h>

#include <algorithm>

namespace burin {
namespace {

std::vector<HidField> of_usage(const std::vector<HidField>& fields, std::uint8_t report,
                               std::uint32_t usage) {
  std::vector<HidField> found;
  std::ranges::copy_if(fields, std::back_inserter(found),
                       [&](const HidField& field) { return field.report == report && field.usage == usage; });
  return found;
}

double position(const HidField& field, std::int32_t value) {
  const double unit = hid_millimetres(field);
  return unit > 0 ? hid_physical(field, value) * unit : value;
}

}  // namespace

HidTouches::HidTouches(const std::vector<HidField>& fields) {
  for (const HidField& field : fields) {
    if (reports_.contains(field.report)) continue;
    const auto of = [&](std::uint32_t usage) { return of_usage(fields, field.report, usage); };
    const std::vector<HidField> tips = of(usage_tip), ids = of(usage_contact_id), x = of(usage_x),
                                y = of(usage_y);
    Report report;
    const std::size_t touches = std::min({tips.size(), ids.size(), x.size(), y.size()});
    for (std::size_t i = 0; touches > 1 && i < touches; ++i)
      report.places.push_back({tips[i], ids[i], x[i], y[i]});
    report.count = of(usage_contact_count);
    reports_.emplace(field.report, std::move(report));
  }
}

bool HidTouches::take(double time, std::span<const std::uint8_t> report, PenFile& content) {
  const bool has_ids = !reports_.contains(0);
  const auto known = reports_.find(has_ids && !report.empty() ? report.front() : std::uint8_t{0});
  if (known == reports_.end() || known->second.places.empty()) return false;
  const auto bytes = report.subspan(has_ids ? 1 : 0);
  const auto value = [&](const HidField& field) {
    return field.bit + field.bits <= 8 * bytes.size() ? hid_value(field, bytes) : 0;
  };
  const Report& fields = known->second;
  const std::size_t count = fields.count.empty()
                                ? fields.places.size()
                                : static_cast<std::size_t>(std::max(value(fields.count.front()), 0));
  std::vector<std::int32_t> ended;
  std::vector<Touch> down;
  for (std::size_t i = 0; i < fields.places.size(); ++i) {
    const Place& place = fields.places[i];
    if (value(place.tip) != 0) {
      down.push_back(
          {value(place.id), {position(place.x, value(place.x)), position(place.y, value(place.y)), 0}});
    } else if (i < count) {
      ended.push_back(value(place.id));
    }
  }
  if (hid_millimetres(fields.places.front().x) > 0) content.unit = "mm";
  end(ended, down);
  for (const Touch& touch : down) add(touch, time, content);
  if (down.empty()) ++content.hovering;
  return true;
}

/// Ends touches, unless the same report has them down: rooms without a touch have an id too.
void HidTouches::end(const std::vector<std::int32_t>& ended, const std::vector<Touch>& down) {
  for (const std::int32_t id : ended)
    if (std::ranges::find(down, id, &Touch::id) == down.end()) strokes_.erase(id);
}

void HidTouches::add(const Touch& touch, double time, PenFile& content) {
  const auto [stroke, begins] = strokes_.try_emplace(touch.id, content.strokes.size());
  if (begins) {
    PenStroke& made = content.strokes.emplace_back();
    made.tool = "touch";
    made.fields.time = true;
  }
  content.strokes[stroke->second].samples.push_back({.time = time, .position = touch.position, .pen = {}});
}

}  // namespace burin
