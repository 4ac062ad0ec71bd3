// Collects the timestamps of InkML contexts. A timestamp tells a time itself, or one that comes so long after
// another one.
#include <burin/ink/decode/inkml_clocks.h>
#include <burin/ink/decode/inkml_format.h>
#include <burin/ink/parse/iso_time.h>

#include <algorithm>

namespace burin {
namespace {

template <class Clocks>
std::optional<double> named(const Clocks& clocks, const pugi::xml_attribute& reference) {
  const auto found = clocks.find(std::string_view(reference.value()));
  return found == clocks.end() ? std::nullopt : found->second;
}

}  // namespace

InkmlClocks::InkmlClocks(const XmlFile& file) {
  collect(file.root());
  for (const auto& [reference, clock] : contexts_)
    if (clock) earliest_ = std::min(*clock, earliest_.value_or(*clock));
}

void InkmlClocks::collect(const pugi::xml_node& node) {
  const std::string_view name = local_name(node.name());
  if (name == "trace") return;
  if (name == "timestamp") stamps_[std::string("#") + attribute(node, "id").value()] = time_of(node);
  if (name == "context") take_context(node);
  for (const pugi::xml_node& one : node.children()) collect(one);
}

InkmlClocks::Clock InkmlClocks::time_of(const pugi::xml_node& stamp) const {
  constexpr double milliseconds = 1000;
  Clock time = number_of(attribute(stamp, "time"));
  if (!time)
    if (const auto told = iso_time(attribute(stamp, "timeString").value())) time = *told * milliseconds;
  if (!time) time = named(stamps_, attribute(stamp, "timestampRef"));
  if (time) *time += number_of(attribute(stamp, "timeOffset")).value_or(0);
  return time;
}

/// A context has a timestamp, names one that came before, or has that of the context that it names.
void InkmlClocks::take_context(const pugi::xml_node& context) {
  const pugi::xml_node own = child(context, "timestamp");
  Clock clock = own ? time_of(own) : named(stamps_, attribute(context, "timestampRef"));
  if (!clock) clock = named(contexts_, attribute(context, "contextRef"));
  contexts_[InkmlFormats::reference_of(context)] = clock;
}

double InkmlClocks::of(std::string_view context) const {
  const auto found = contexts_.find(context);
  if (found == contexts_.end() || !found->second) return 0;
  return (*found->second - *earliest_) / 1000;
}

}  // namespace burin
